#include <doctest/doctest.h>

#include "methods/stopping_rule.h"
#include "session/session.h"
#include "support/runs.h"
#include "support/shapes.h"

using namespace whittle;
using namespace whittle::testing;

namespace {

StepReport report(double energy, double change) { return {Outcome::running, energy, change}; }

Run carve(const TriangleMesh& mesh, const std::string& stopOn, double tolerance) {
  Session session;
  REQUIRE(session.load(mesh).ok());
  REQUIRE(session.select("cubic").ok());
  REQUIRE(session.set("stopOn", encoded(stopOn)).ok());
  REQUIRE(session.set("tolerance", encoded(tolerance)).ok());
  REQUIRE(session.prepare().ok());
  return finish(session);
}

}  // namespace

TEST_CASE("stopping on displacement looks at the change alone") {
  StoppingRule rule;
  rule.tolerance = 0.01;
  rule.begin();
  CHECK(rule.judge(report(5, 0.5)) == Outcome::running);
  CHECK(rule.judge(report(5, 0.02)) == Outcome::running);
  CHECK(rule.judge(report(5, 0.01)) == Outcome::converged);
}

TEST_CASE("stopping on energy wants two small decreases in a row") {
  StoppingRule rule;
  rule.quantity = StoppingRule::Quantity::energy;
  rule.tolerance = 0.01;
  rule.begin();
  CHECK(rule.judge(report(100, 1)) == Outcome::running);
  CHECK(rule.judge(report(99.5, 1)) == Outcome::running);
  CHECK(rule.judge(report(90, 1)) == Outcome::running);
  CHECK(rule.judge(report(89.5, 1)) == Outcome::running);
  CHECK(rule.judge(report(89, 1)) == Outcome::converged);
  rule.begin();
  CHECK(rule.judge(report(89, 1)) == Outcome::running);
  CHECK(rule.judge(report(89, 0)) == Outcome::converged);  // at rest
}

TEST_CASE("the iteration limit and a stalled energy end a run") {
  StoppingRule rule;
  rule.tolerance = 0;
  rule.maxIterations = 2;
  rule.begin();
  CHECK(rule.judge(report(2, 1)) == Outcome::running);
  CHECK(rule.judge(report(1, 1)) == Outcome::iterationLimit);
  CHECK(rule.exhausted());
  rule.maxIterations = 1000;
  rule.begin();
  int iterations = 1;
  while (rule.judge(report(1, 1)) == Outcome::running) ++iterations;
  CHECK(iterations == 101);
}

TEST_CASE("a run stops on the energy it was told to") {
  const TriangleMesh mesh = bent(sphere(3));
  const double converged = carve(mesh, "displacement", 1e-6).energies.back();
  std::size_t before = 0;
  for (const double tolerance : {1e-2, 1e-3, 1e-4, 1e-5}) {
    const Run run = carve(mesh, "energy", tolerance);
    CHECK(run.outcome == Outcome::converged);
    const std::size_t n = run.energies.size();
    CHECK(n >= before);
    before = n;
    for (const std::size_t k : {n - 1, n - 2})
      CHECK(run.energies[k - 1] - run.energies[k] <= tolerance * run.energies[k - 1]);
    CHECK(run.energies.back() <= converged * (1 + 50 * tolerance));
  }
}
