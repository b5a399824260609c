#include "methods/local_global/cubic/style_frames.h"

#include "geometry/rotation_newton.h"

namespace whittle {

namespace {

bool isIdentity(const Quaternion& q) { return q.head<3>().isZero(0); }

void setQuaternion(QuaternionLanes& q, int lane, const Quaternion& value) {
  q.x[lane] = static_cast<float>(value.x());
  q.y[lane] = static_cast<float>(value.y());
  q.z[lane] = static_cast<float>(value.z());
  q.w[lane] = static_cast<float>(value.w());
}

}  // namespace

void StyleFrames::prepare(const Quaternion& orientation, const Quaternions& own, Index vertexCount) {
  const auto frameAt = [&](Index v) -> Quaternion {
    const bool hasOwn = own.rows() && !own.row(v).isZero(0);
    const Quaternion q = hasOwn ? Quaternion(own.row(v).transpose()) : orientation;
    return q.stableNormalized();
  };
  frames_.clear();
  bool areAllIdentity = true;
  for (Index v = 0; v < vertexCount && areAllIdentity; ++v) areAllIdentity = isIdentity(frameAt(v));
  if (areAllIdentity) return;
  frames_.assign(batchCount(vertexCount), identityRotations());
  for (Index v = 0; v < vertexCount; ++v) setQuaternion(frames_[v / 4], v % 4, frameAt(v));
}

void StyleFrames::outOfFrames(std::size_t batch, const QuaternionLanes& before, const QuaternionLanes& after,
                              QuaternionLanes& rotations) const {
  const Lanes w = after.w - before.w, x = after.x - before.x, y = after.y - before.y, z = after.z - before.z;
  constexpr float kSame = kTurnOfRounding / 2;  // of quaternions, which turn half as far
  const LaneMask isSame = w * w + x * x + y * y + z * z <= kSame * kSame;
  rotations = select(isSame, rotations, normalized(frames_[batch] * after));
}

}  // namespace whittle
