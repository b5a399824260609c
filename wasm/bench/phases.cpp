#include "bench/phases.h"

#include "linear/sparse_cholesky.h"

namespace whittle::bench {

namespace {

constexpr int kPrepareRounds = 5;
constexpr int kIterationRounds = 9;
constexpr int kBlock = 4;   // iterations of one side in a row, as in a real run
constexpr int kWarmUp = 3;  // iterations before the clock starts: ADMM's first steps are many

/// Calls `round` so often, or once and then until the time is over; returns how often.
template <typename Round>
int repeat(int most, double seconds, Round&& round) {
  const double end = milliseconds() + 1000 * seconds;
  int rounds = 0;
  do {
    round();
    ++rounds;
  } while (rounds < most && milliseconds() < end);
  return rounds;
}

struct PrepareTimes {
  Samples whole, order, factor;

  Json json() const {
    // The linear solver is timed on its own; what is left of the whole is assembly.
    const double other = std::max(0.0, whole.median() - order.median() - factor.median());
    return Json().add("whole", whole.median()).add("order", order.median()).add("factor", factor.median()).add("other", other);
  }
};

Json measurePrepare(const Problem& problem, double seconds) {
  PrepareTimes ours, plain;
  const int rounds = repeat(kPrepareRounds, seconds, [&] {
    Session session;
    require(open(session, problem));
    ours.whole.add(timed([&] { require(session.prepare()); }));

    PlainLocalGlobal yardstick(problem.mesh, problem.plain);
    const double assemble = timed([&] { yardstick.assemble(); });
    const double analyze = timed([&] { yardstick.analyze(); });
    const double factorize = timed([&] { yardstick.factorize(); });
    plain.order.add(analyze);
    plain.factor.add(factorize);
    plain.whole.add(assemble + analyze + factorize);

    SparseCholesky cholesky;
    ours.order.add(timed([&] { cholesky.analyze(yardstick.freeBlock()); }));
    ours.factor.add(timed([&] { require(cholesky.factorize(yardstick.freeBlock())); }));
  });
  return Json().add("ours", ours.json()).add("plain", plain.json()).add("rounds", rounds);
}

Json measureIteration(const Problem& problem, double seconds) {
  Session session;
  require(open(session, problem));
  require(session.prepare());
  PlainLocalGlobal yardstick(problem.mesh, problem.plain);
  Points positions = problem.mesh.positions, before;
  yardstick.prepare();
  yardstick.begin(positions);
  SparseCholesky cholesky;
  cholesky.analyze(yardstick.freeBlock());
  require(cholesky.factorize(yardstick.freeBlock()));
  const Points rhs = Points::Random(yardstick.freeBlock().rows(), 3);
  Points solution = rhs;

  StepReport report;
  for (int k = 0; k < kWarmUp; ++k) {
    require(session.step(report));
    yardstick.iterate(positions);
  }
  Samples step, solve, plainLocal, plainRightHandSide, plainSolve, plainWhole;
  const int rounds = repeat(kIterationRounds, seconds, [&] {
    for (int k = 0; k < kBlock; ++k) step.add(timed([&] { require(session.step(report)); }));
    for (int k = 0; k < kBlock; ++k) {
      solution = rhs;
      solve.add(timed([&] { cholesky.solve(solution); }));
    }
    for (int k = 0; k < kBlock / 2; ++k) {
      before = positions;
      const double local = timed([&] { yardstick.localStep(positions); });
      const double right = timed([&] { yardstick.rightHandSide(); });
      const double solved = timed([&] { yardstick.solve(positions); });
      const double stop = timed([&] { relativeDisplacement(before, positions, problem.mesh.positions); });
      plainLocal.add(local);
      plainRightHandSide.add(right);
      plainSolve.add(solved);
      plainWhole.add(local + right + solved + stop);
    }
  });
  Json ours, plain;
  ours.add("whole", step.median()).add("solve", solve.median()).add("local", std::max(0.0, step.median() - solve.median()));
  plain.add("whole", plainWhole.median()).add("solve", plainSolve.median());
  plain.add("local", plainLocal.median()).add("rightHandSide", plainRightHandSide.median());
  return Json().add("ours", ours).add("plain", plain).add("rounds", rounds);
}

}  // namespace

Json measurePhases(const Problem& problem, double seconds) {
  return Json()
      .add("prepare", measurePrepare(problem, seconds / 2))
      .add("iteration", measureIteration(problem, seconds / 2));
}

}  // namespace whittle::bench
