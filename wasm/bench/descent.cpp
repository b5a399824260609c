#include "bench/descent.h"

#include "bench/measure.h"

namespace whittle::bench {

namespace {

constexpr double kPaperStop = 3e-3;
constexpr int kAtRest = 50;            // iterations in which …
constexpr double kRestingFall = 1e-7;  // … a resting energy falls by less than this share
constexpr int kMaxIterations = 3000;

bool rests(const std::vector<double>& energies) {
  const std::size_t count = energies.size();
  return count > kAtRest && energies[count - 1 - kAtRest] - energies[count - 1] < kRestingFall * energies[count - 1];
}

}  // namespace

double Descent::lowest() const { return *std::min_element(energies.begin(), energies.end()); }

int Descent::iterationsTo(double bound) const {
  for (std::size_t k = 0; k < energies.size(); ++k) {
    if (energies[k] <= bound) return static_cast<int>(k);
  }
  return -1;
}

Descent descend(const Problem& problem, double seconds, double enough) {
  Descent run;
  const double start = milliseconds();
  const auto isDone = [&] {
    const int count = static_cast<int>(run.energies.size());
    run.rested = rests(run.energies);
    // One iteration behind the stop tells the energy there.
    const bool isEnough = run.stop >= 0 && count > run.stop && run.energies.back() <= enough;
    return run.rested || isEnough || count >= kMaxIterations || milliseconds() - start > 1000 * seconds;
  };
  Session session;
  require(open(session, problem));
  require(session.prepare());
  while (!isDone()) {
    run.times.push_back(milliseconds() - start);
    StepReport report;
    require(session.step(report));
    run.energies.push_back(report.energy);
    if (run.stop < 0 && report.change <= kPaperStop) run.stop = static_cast<int>(run.energies.size());
  }
  return run;
}

Descent descendPlainly(const Problem& problem, double seconds, double enough) {
  Descent run;
  double clock = 0;
  PlainLocalGlobal plain(problem.mesh, problem.plain);
  Points positions = problem.mesh.positions, before;
  clock += timed([&] {
    if (!plain.prepare()) require(Status::failure(Code::numericalFailure, "the plain system is not positive definite"));
    plain.begin(positions);
  });
  const double prepared = clock;
  for (bool last = false; !last;) {
    // One local step more, for the energy at the end.
    last = (run.stop >= 0 && run.energies.back() <= enough) || clock - prepared > 1000 * seconds;
    run.times.push_back(clock);
    clock += timed([&] { plain.localStep(positions); });
    run.energies.push_back(plain.energy(positions));
    if (last) break;
    double change = 0;
    clock += timed([&] {
      before = positions;
      plain.rightHandSide();
      plain.solve(positions);
      change = relativeDisplacement(before, positions, problem.mesh.positions);
    });
    if (run.stop < 0 && change <= kPaperStop) run.stop = static_cast<int>(run.energies.size());
  }
  return run;
}

}  // namespace whittle::bench
