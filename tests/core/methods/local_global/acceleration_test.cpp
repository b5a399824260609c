#include <doctest/doctest.h>

#include <cmath>

#include "session/session.h"
#include "support/allocations.h"
#include "support/runs.h"
#include "support/shapes.h"

using namespace whittle;
using namespace whittle::testing;

namespace {

const std::string exact = "exact", admm = "admm";
const std::string nesterov = "nesterov", relaxed = "relaxed", none = "none";

struct Setup {
  double lambda = 0.4;
  std::string localStep = exact;
  std::string acceleration = nesterov;
  double tolerance = 3e-3;
  int maxIterations = 1000;
  Handles handles = {};
};

void open(Session& session, const TriangleMesh& mesh, const Setup& setup) {
  REQUIRE(session.load(mesh).ok());
  REQUIRE(session.select("cubic").ok());
  REQUIRE(session.set("lambda", encoded(setup.lambda)).ok());
  REQUIRE(session.set("localStep", encoded(setup.localStep)).ok());
  REQUIRE(session.set("acceleration", encoded(setup.acceleration)).ok());
  REQUIRE(session.set("tolerance", encoded(setup.tolerance)).ok());
  REQUIRE(session.set("maxIterations", encoded(setup.maxIterations)).ok());
  REQUIRE(session.set("handles", encoded(setup.handles)).ok());
  REQUIRE(session.prepare().ok());
}

Run run(const TriangleMesh& mesh, const Setup& setup) {
  Session session;
  open(session, mesh, setup);
  return finish(session);
}

/// Iterations until the energy is within `share` of the lowest.
std::size_t iterationsTo(const std::vector<double>& energies, double lowest, double share) {
  std::size_t k = 0;
  while (k < energies.size() && energies[k] > lowest * (1 + share)) ++k;
  return k + 1;
}

std::vector<Setup> combinations(double lambda) {
  std::vector<Setup> setups;
  for (const std::string& step : {exact, admm}) {
    for (const std::string& acceleration : {nesterov, relaxed, none}) setups.push_back({lambda, step, acceleration});
  }
  return setups;
}

}  // namespace

TEST_CASE("the energy never rises, whatever the local step and the acceleration") {
  const TriangleMesh mesh = bent(sphere(3));
  Handles handles{{0, 1, 7}, Points(3, 3)};
  for (int h = 0; h < 3; ++h) handles.targets.row(h) = mesh.positions.row(handles.vertices[h]);
  handles.targets.row(1) += Eigen::RowVector3d(-0.7, 0.2, 0.4);
  for (const double lambda : {0.0, 0.3, 2.5, 5.5}) {
    for (Setup setup : combinations(lambda)) {
      for (const Handles& held : {Handles{}, handles}) {
        setup.handles = held;
        setup.tolerance = 1e-5;
        setup.maxIterations = 40;
        const Run result = run(mesh, setup);
        CAPTURE(lambda);
        CAPTURE(setup.localStep);
        CAPTURE(setup.acceleration);
        for (std::size_t k = 1; k < result.energies.size(); ++k) {
          REQUIRE(result.energies[k] <= result.energies[k - 1] + 1e-7 * std::abs(result.energies[0]) + 1e-13);
        }
        for (std::size_t h = 0; h < held.vertices.size(); ++h) {
          REQUIRE((result.positions.row(held.vertices[h]) - held.targets.row(h)).norm() < 1e-12);
        }
      }
    }
  }
}

TEST_CASE("acceleration needs half of the iterations or fewer, and the optimum is the same") {
  for (const TriangleMesh& mesh : {sphere(4), bent(sphere(4))}) {
    const Run accelerated = run(mesh, {0.3, exact, nesterov, 1e-6, 200});
    const Run overRelaxed = run(mesh, {0.3, exact, relaxed, 1e-6, 150});
    const Run plain = run(mesh, {0.3, exact, none, 1e-6, 250});
    const double lowest = accelerated.energies.back();
    CHECK(overRelaxed.energies.back() == doctest::Approx(lowest).epsilon(1e-3));
    CHECK(plain.energies.back() == doctest::Approx(lowest).epsilon(1e-3));
    const std::size_t needed = iterationsTo(plain.energies, lowest, 1e-3);
    REQUIRE(needed <= 250);
    CHECK(2 * iterationsTo(accelerated.energies, lowest, 1e-3) <= needed);
    CHECK(1.5 * iterationsTo(overRelaxed.energies, lowest, 1e-3) <= needed);
  }
}

TEST_CASE("at the paper's stop the exact step is no higher than ADMM") {
  for (const TriangleMesh& mesh : {bent(sphere(3)), bent(grid(20))}) {
    for (const double lambda : {0.2, 0.8}) {
      const double byDefault = run(mesh, {lambda}).energies.back();
      for (const std::string& acceleration : {nesterov, relaxed, none}) {
        const double ofExact = run(mesh, {lambda, exact, acceleration}).energies.back();
        const double ofAdmm = run(mesh, {lambda, admm, acceleration}).energies.back();
        CHECK(ofExact <= ofAdmm * (1 + 1e-4));
        CHECK(byDefault <= ofAdmm * (1 + 1e-4));
      }
    }
  }
}

TEST_CASE("every combination gives the same bits twice and allocates nothing") {
  const TriangleMesh mesh = bent(sphere(3));
  for (Setup setup : combinations(0.5)) {
    setup.maxIterations = 30;
    CHECK(run(mesh, setup).positions == run(mesh, setup).positions);
    Session session;
    open(session, mesh, setup);
    StepReport report;
    const long before = allocationCount();
    for (int step = 0; step < 15; ++step) REQUIRE(session.step(report).ok());
    CHECK(allocationCount() == before);
  }
}
