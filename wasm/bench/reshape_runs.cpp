#include "bench/reshape_runs.h"

#include "bench/gestures.h"
#include "bench/reshape_solvers.h"
#include "session/session.h"

namespace whittle::bench {

namespace {

void open(Session& session, const Gesture& gesture, const char* reading) {
  require(session.load(gesture.mesh));
  require(session.select("reshape"));
  require(session.set("reading", encoded(std::string(reading))));
  require(session.set("handles", encoded(gesture.handles)));
}

/// Iterates until there is another picture.
StepReport stepWhole(Session& session) {
  StepReport report;
  do {
    require(session.step(report));
  } while (report.outcome == Outcome::midway);
  return report;
}

Json timeRun(const Gesture& gesture) {
  Session session;
  const double start = milliseconds();
  open(session, gesture, "tuned");
  require(session.prepare());
  const double ready = milliseconds() - start;
  StepReport report = stepWhole(session);
  const double first = milliseconds() - start;
  int iterations = 1;
  for (; report.outcome == Outcome::running; ++iterations) report = stepWhole(session);
  return Json()
      .add("name", gesture.name)
      .add("faces", gesture.mesh.faceCount())
      .add("ready", ready)
      .add("first", first)
      .add("final", milliseconds() - start)
      .add("iterations", iterations);
}

/// Iterations as printed, core and reference by turns.
Json compareIterations(const Gesture& given, double seconds) {
  const Gesture gesture = inUnitFrame(given);
  Comparison whole;
  PlainReshape plain = plainOn(printedSurface(gesture.mesh), gesture.handles);
  Session session;
  open(session, gesture, "published");
  require(session.prepare());
  const double end = milliseconds() + 1000 * seconds;
  double plainTime = 0;
  bool goesOn = true, isRunning = true;
  while (goesOn && milliseconds() < end) {
    const double theirs = timed([&] { goesOn = plain.iterate(); });
    plainTime += theirs;
    const double ours = timed([&] {
      if (!isRunning) session.restart(), require(session.prepare());
      isRunning = stepWhole(session).outcome == Outcome::running;
    });
    if (plain.iterations() > 1 && goesOn) whole.add(ours, theirs);  // the first analyzes, the last does half
  }
  return Json()
      .add("iteration", whole.json())
      .add("plainIterations", plain.iterations())
      .add("plainTime", plainTime)
      .add("plainFinished", !goesOn);
}

}  // namespace

Json measureReshape(Index faces, double seconds) {
  const Gesture first = plateGesture(faces);
  Json result;
  result.add("cold", timeRun(first)).add("memory", peakMemory());
  result.addJson("runs", jsonList(gestures(faces), [](const Gesture& each) { return timeRun(each).text(); }));
  if (first.mesh.faceCount() <= kMostPlainFaces) {
    result.add("compared", compareIterations(first, seconds)).add("solvers", measureSolvers(first));
  }
  return result;
}

}  // namespace whittle::bench
