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

/// A side at work on an iteration; the solve of three right-hand sides is timed on its own, by turns with the whole.
struct IterationTimes {
  Samples whole, solve;

  Json json() const {
    const double rest = std::max(0.0, whole.median() - solve.median());
    return Json().add("whole", whole.median()).add("solve", solve.median()).add("rest", rest);
  }
};

/// The core's session and its linear solver.
class Ours {
 public:
  Ours(const Problem& problem, const SparseMatrix& system) {
    require(open(session_, problem));
    require(session_.prepare());
    cholesky_.analyze(system);
    require(cholesky_.factorize(system));
  }
  void step() {
    StepReport report;
    require(session_.step(report));
  }
  double solve(const Points& rhs) {
    solution_ = rhs;
    return timed([&] { cholesky_.solve(solution_); });
  }

 private:
  Session session_;
  SparseCholesky cholesky_;
  Points solution_;
};

/// The yardstick in a run, stopping rule included.
class Plain {
 public:
  explicit Plain(const Problem& problem)
      : rest_(problem.mesh.positions), solver_(problem.mesh, problem.plain), positions_(problem.mesh.positions) {
    solver_.prepare();
    solver_.begin(positions_);
  }
  void step() {
    before_ = positions_;
    local_.add(timed([&] { solver_.localStep(positions_); }));
    rightHandSide_.add(timed([&] { solver_.rightHandSide(); }));
    solver_.solve(positions_);
    change_ = relativeDisplacement(before_, positions_, rest_);
  }
  double solve(const Points& rhs) {
    const Eigen::MatrixXd b = rhs;
    Eigen::MatrixXd solution;
    return timed([&] { solution = solver_.cholesky().solve(b); });
  }
  const SparseMatrix& system() const { return solver_.freeBlock(); }
  double local() const { return local_.median(); }
  double rightHandSide() const { return rightHandSide_.median(); }

 private:
  const Points& rest_;
  PlainLocalGlobal solver_;
  Points positions_, before_;
  Samples local_, rightHandSide_;
  double change_ = 0;
};

Json measureIteration(const Problem& problem, double seconds) {
  Plain plain(problem);
  Ours ours(problem, plain.system());
  const Points rhs = Points::Random(plain.system().rows(), 3);
  for (int k = 0; k < kWarmUp; ++k) {
    ours.step();
    plain.step();
  }
  IterationTimes oursTimes, plainTimes;
  const auto block = [&](auto& side, IterationTimes& times, int count) {
    for (int k = 0; k < count; ++k) times.whole.add(timed([&] { side.step(); }));
    for (int k = 0; k < count; ++k) times.solve.add(side.solve(rhs));
  };
  const int rounds = repeat(kIterationRounds, seconds, [&] {
    block(ours, oursTimes, kBlock);
    block(plain, plainTimes, kBlock / 2);
  });
  Json plainJson = plainTimes.json();
  plainJson.add("local", plain.local()).add("rightHandSide", plain.rightHandSide());
  return Json().add("ours", oursTimes.json()).add("plain", plainJson).add("rounds", rounds);
}

}  // namespace

Json measurePhases(const Problem& problem, double seconds) {
  return Json()
      .add("prepare", measurePrepare(problem, seconds / 2))
      .add("iteration", measureIteration(problem, seconds / 2));
}

}  // namespace whittle::bench
