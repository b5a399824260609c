#pragma once

#include <vector>

#include "session/session.h"

namespace whittle::testing {

/// What a run came to.
struct Run {
  Points positions;
  std::vector<double> energies;  // one an iteration
  Outcome outcome = Outcome::running;
};

/// Runs a prepared session to its end.
Run finish(Session& session);

}  // namespace whittle::testing
