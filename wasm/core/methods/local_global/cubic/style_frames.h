#pragma once

#include <vector>

#include "methods/values/rotation.h"
#include "methods/values/rotations.h"
#include "simd/lane_algebra.h"

namespace whittle {

/// The frames Q_i in which vertices take on a style (2019, §4, local coordinate frames): the axes of the style as the
/// columns of a rotation. The regularizer is |B Q_iᵀ R n|, so that it all comes to the usual step for M Q and Qᵀ R.
class StyleFrames {
 public:
  /// @param orientation the frame of all vertices
  /// @param own frames of single vertices (#V×4), or none; one of zeros says nothing
  void prepare(const Quaternion& orientation, const Quaternions& own, Index vertexCount);

  /// Whether every frame is that of the file: then there is nothing to turn.
  bool areIdentity() const { return frames_.empty(); }

  MatrixLanes covariances(std::size_t batch, const MatrixLanes& M) const { return M * toMatrix(frames_[batch]); }
  QuaternionLanes intoFrames(std::size_t batch, const QuaternionLanes& rotations) const {
    return inverse(frames_[batch]) * rotations;
  }
  /// The way back. A rotation that did not change but for rounding keeps its bits, so that what is at rest stays there.
  /// @param before in the frames, of which `rotations` are the image outside
  void outOfFrames(std::size_t batch, const QuaternionLanes& before, const QuaternionLanes& after,
                   QuaternionLanes& rotations) const;

 private:
  std::vector<QuaternionLanes> frames_;  // Q; empty where all are the identity
};

}  // namespace whittle
