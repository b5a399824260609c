#include "support/runs.h"

#include <doctest/doctest.h>

namespace whittle::testing {

Run finish(Session& session) {
  Run result;
  while (result.outcome == Outcome::running) {
    StepReport report;
    const Status status = session.step(report);
    REQUIRE_MESSAGE(status.ok(), status.message);
    if (report.outcome == Outcome::midway) continue;
    result.outcome = report.outcome;
    result.energies.push_back(report.energy);
  }
  result.positions.resize(session.report().vertices, 3);
  session.copyPositions(result.positions.data());
  return result;
}

}  // namespace whittle::testing
