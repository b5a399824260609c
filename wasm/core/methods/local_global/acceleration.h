#pragma once

#include "methods/local_global/displacements.h"

namespace whittle {

/// Where each local/global iteration starts from. The iteration is a map G that never raises the energy; from a point
/// y_k it gives the iterate x_{k+1} = G(y_k), and the next starts from
/// - nesterov: y = x_{k+1} + β_k (x_{k+1} − x_k), Nesterov's sequence of β, begun again whenever a step is rejected;
/// - relaxed:  y = y_k + 1.8 (x_{k+1} − y_k), which cannot raise a quadratic energy (below 2);
/// - none:     y = x_{k+1}, the alternation of the papers.
/// The caller rejects a y whose energy lies above that of the point before and starts from x_{k+1} instead, which
/// cannot rise. All y are affine combinations of iterates: held vertices and centroids stay.
class Acceleration {
 public:
  enum class Kind { nesterov, relaxed, none };

  void resize(Index vertexCount, const StiffEdges& stiff) { start_.resize(vertexCount, stiff); }

  /// Forgets all; the first iteration is a plain one.
  void begin(Kind kind);

  /// Computes y from the iterate x and the one before it. Returns whether it is any other point than x.
  bool extrapolate(const Displacements& iterate, const Displacements& before);
  /// Falls back on x.
  void reject(const Displacements& iterate);
  /// y
  const Displacements& start() const { return start_; }

 private:
  Kind kind_ = Kind::nesterov;
  bool fresh_ = true;    // no iteration yet
  double momentum_ = 1;  // Nesterov's t_k
  Displacements start_;  // y
};

}  // namespace whittle
