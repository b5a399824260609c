#include "bench/alone.h"

namespace whittle::bench {

namespace {

constexpr int kFixedCount = 20;  // iterations after which builds are compared

double timePrepare(Session& session, const Problem& problem) {
  return timed([&] {
    require(open(session, problem));
    require(session.prepare());
  });
}

/// A run in this process's first session.
Json measureFresh(const Problem& problem, double seconds) {
  Session session;
  const double fresh = timePrepare(session, problem);
  Samples iterations;
  std::vector<double> energies;
  StepReport report;
  const double start = milliseconds();
  do {
    iterations.add(timed([&] { require(session.step(report)); }));
    energies.push_back(report.energy);
  } while (report.outcome == Outcome::running && milliseconds() - start < 1000 * seconds);
  return Json()
      .add("fresh", fresh)
      .add("iteration", iterations.median())
      .add("iterations", static_cast<double>(energies.size()))
      .add("finished", report.outcome != Outcome::running)
      .add("time", milliseconds() - start)
      .add("firstEnergy", energies.front())
      .add("lastEnergy", energies.back())
      .add("energyAtFixedCount", energies[std::min<std::size_t>(kFixedCount, energies.size() - 1)]);
}

}  // namespace

Json measureAlone(const Problem& problem, double seconds) {
  Json result = measureFresh(problem, seconds);
  Session again;
  return result.add("warm", timePrepare(again, problem));
}

}  // namespace whittle::bench
