#pragma once

#include <vector>

#include "geometry/edge_set.h"
#include "geometry/rotation_fit.h"
#include "methods/parameters.h"

namespace whittle {

/// What a local step may know of the rest shape; everything in the unit frame.
struct RestShape {
  const TriangleMesh& mesh;
  Scalars areas;   // #V, barycentric
  Points normals;  // #V×3, unit or zero
};

/// The policy of a local/global method: how each element's rotation is chosen.
class LocalStep {
 public:
  virtual ~LocalStep() = default;

  virtual EdgeSetKind edgeSet() const { return EdgeSetKind::spokesAndRims; }

  /// Takes the parameters that the policy knows; called when weights or more are stale. `rest` outlives the policy’s use.
  virtual void prepare(const RestShape& rest, const Settings& settings) = 0;

  /// Forgets what earlier iterations left.
  virtual void begin() {}

  /// Finds the rotations R of four elements that are best for their covariances M (tr(R M) is to be large), starting from those
  /// given. Returns their regularizers. Allocates nothing.
  /// @param neverWorse whether no rotation may be worse than it was, where the policy does not promise that anyway
  virtual Lanes fit(std::size_t batch, const ScaledCovariances& covariances, bool neverWorse, QuaternionLanes& rotations) = 0;
};

}  // namespace whittle
