#include "bench/phases.h"

#include "linear/sparse_cholesky.h"

namespace whittle::bench {

namespace {

constexpr int kPrepareRounds = 5;
constexpr int kIterationRounds = 25;
constexpr int kBlock = 5;  // iterations in a row, as in a real run
constexpr int kPlainBlock = 3;
constexpr int kWarmUp = 3;           // iterations before the clock starts: ADMM's first steps are many
constexpr double kPaperStop = 3e-3;  // relative displacement; a run that is there begins anew

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

Json measurePrepare(const Problem& problem, double seconds) {
  Comparison whole, order, factor;
  const int rounds = repeat(kPrepareRounds, seconds, [&] {
    Session session;
    require(open(session, problem));
    const double prepare = timed([&] { require(session.prepare()); });

    PlainLocalGlobal plain(problem.mesh, problem.plain);
    const double plainAssemble = timed([&] { plain.assemble(); });
    const double plainOrder = timed([&] { plain.analyze(); });
    const double plainFactor = timed([&] { plain.factorize(); });
    whole.add(prepare, plainAssemble + plainOrder + plainFactor);

    SparseCholesky cholesky;
    order.add(timed([&] { cholesky.analyze(plain.freeBlock()); }), plainOrder);
    factor.add(timed([&] { require(cholesky.factorize(plain.freeBlock())); }), plainFactor);
  });
  return Json()
      .add("whole", whole.json())
      .add("order", order.json())
      .add("factor", factor.json())
      .add("rounds", rounds);
}

/// The core's session and its linear solver.
class Ours {
 public:
  Ours(const Problem& problem, const SparseMatrix& system) {
    require(open(session_, problem));
    cholesky_.analyze(system);
    require(cholesky_.factorize(system));
  }
  void restart() {
    session_.restart();
    require(session_.prepare());
  }
  /// Returns the relative displacement.
  double step() {
    StepReport report;
    require(session_.step(report));
    return report.change;
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

/// The reference in a run, stopping rule included.
class Plain {
 public:
  explicit Plain(const Problem& problem)
      : rest_(problem.mesh.positions), solver_(problem.mesh, problem.plain), positions_(problem.mesh.positions) {
    solver_.prepare();
  }
  void restart() {
    positions_ = rest_;
    solver_.begin(positions_);
  }
  double step() {
    before_ = positions_;
    local_.add(timed([&] { solver_.localStep(positions_); }));
    rightHandSide_.add(timed([&] { solver_.rightHandSide(); }));
    solver_.solve(positions_);
    return relativeDisplacement(before_, positions_, rest_);
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
};

/// Medians of a few iterations and a few solves of one side.
struct Block {
  double whole, solve;
};

template <typename Side>
double begin(Side& side) {
  side.restart();
  for (int k = 1; k < kWarmUp; ++k) side.step();
  return side.step();
}

/// @param change relative displacement of the side's last iteration
template <typename Side>
Block timeBlock(Side& side, double& change, const Points& rhs, int count) {
  Samples whole, solve;
  for (int k = 0; k < count; ++k) {
    if (change <= kPaperStop) begin(side);
    whole.add(timed([&] { change = side.step(); }));
  }
  for (int k = 0; k < count; ++k) solve.add(side.solve(rhs));
  return {whole.median(), solve.median()};
}

Json measureIteration(const Problem& problem, double seconds) {
  Plain plain(problem);
  Ours ours(problem, plain.system());
  const Points rhs = Points::Random(plain.system().rows(), 3);
  double change = begin(ours), plainChange = begin(plain);
  Comparison whole, solve, rest;
  const int rounds = repeat(kIterationRounds, seconds, [&] {
    const Block mine = timeBlock(ours, change, rhs, kBlock);
    const Block theirs = timeBlock(plain, plainChange, rhs, kPlainBlock);
    whole.add(mine.whole, theirs.whole);
    solve.add(mine.solve, theirs.solve);
    rest.add(std::max(0.0, mine.whole - mine.solve), theirs.whole - theirs.solve);
  });
  return Json()
      .add("whole", whole.json())
      .add("solve", solve.json())
      .add("rest", rest.json())
      .add("plainLocal", plain.local())
      .add("plainRightHandSide", plain.rightHandSide())
      .add("rounds", rounds);
}

}  // namespace

Json measurePhases(const Problem& problem, double seconds) {
  return Json().add("prepare", measurePrepare(problem, seconds)).add("iteration", measureIteration(problem, seconds));
}

}  // namespace whittle::bench
