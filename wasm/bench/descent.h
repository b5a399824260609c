#pragma once

#include <vector>

#include "bench/problem.h"

namespace whittle::bench {

/// A run, iteration by iteration. The clock starts with the loaded mesh, before anything is prepared.
struct Descent {
  std::vector<double> energies;  // [k] after k iterations, with the next local step's rotations
  std::vector<double> times;     // [k] when k iterations were done, in ms
  int stop = -1;                 // iterations at the papers' own stop, relative displacement 3e-3; −1 if never

  bool rested = false;  // whether the energy came to rest

  double lowest() const;
  /// Iterations until the energy is at most `bound`; −1 if it never is.
  int iterationsTo(double bound) const;
};

/// The core, run until its energy rests, or is as low as `enough` behind the papers' stop, or the time is over.
Descent descend(const Problem& problem, double seconds, double enough = 0);

/// The reference, run until it is as low as `enough` behind the papers' stop or the time is over, preparing not
/// counted. Energies are worked out off the clock.
Descent descendPlainly(const Problem& problem, double seconds, double enough);

}  // namespace whittle::bench
