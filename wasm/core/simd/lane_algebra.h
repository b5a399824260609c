#pragma once

#include "base/types.h"
#include "simd/lanes.h"

namespace whittle {

/// Four vectors, four 3×3 matrices (row by row), four rotations, four symmetric matrices: one in each lane.
struct VectorLanes {
  Lanes x, y, z;
};

struct MatrixLanes {
  Lanes m[3][3];
};

/// Which rows the lanes of a batch are.
struct RowIndices {
  Index of[4];
};

inline void setRow(LaneRow& row, const Vec3& v) {
  row = {static_cast<float>(v.x()), static_cast<float>(v.y()), static_cast<float>(v.z()), 0};
}

/// Unit quaternions w + xi + yj + zk.
struct QuaternionLanes {
  Lanes w, x, y, z;
};

struct SymmetricLanes {
  Lanes xx, xy, xz, yy, yz, zz;
};

/// Four rows, one a lane.
inline VectorLanes lanesOf(Lanes a, Lanes b, Lanes c, Lanes d) {
  transpose(a, b, c, d);
  return {a, b, c};
}

/// Four rows that follow each other.
inline VectorLanes loadRows(const LaneRow* rows) {
  return lanesOf(load(rows), load(rows + 1), load(rows + 2), load(rows + 3));
}

inline VectorLanes loadRows(const LaneRow* rows, const RowIndices& at) {
  return lanesOf(load(rows + at.of[0]), load(rows + at.of[1]), load(rows + at.of[2]), load(rows + at.of[3]));
}

/// Adds the lanes of v to four rows that follow each other.
inline void addToRows(LaneRow* rows, const VectorLanes& v) {
  Lanes lanes[] = {v.x, v.y, v.z, splat(0)};
  transpose(lanes[0], lanes[1], lanes[2], lanes[3]);
  for (int lane = 0; lane < 4; ++lane) store(rows + lane, load(rows + lane) + lanes[lane]);
}

/// Adds the lanes of v to four rows, one after the other: they may be the same.
inline void addToRows(LaneRow* rows, const RowIndices& at, const VectorLanes& v) {
  Lanes lanes[] = {v.x, v.y, v.z, splat(0)};
  transpose(lanes[0], lanes[1], lanes[2], lanes[3]);
  for (int lane = 0; lane < 4; ++lane) store(rows + at.of[lane], load(rows + at.of[lane]) + lanes[lane]);
}

inline VectorLanes operator+(const VectorLanes& a, const VectorLanes& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline VectorLanes operator-(const VectorLanes& a, const VectorLanes& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline VectorLanes operator*(Lanes s, const VectorLanes& a) { return {s * a.x, s * a.y, s * a.z}; }
inline VectorLanes keep(LaneMask mask, const VectorLanes& a) {
  return {keep(mask, a.x), keep(mask, a.y), keep(mask, a.z)};
}

inline VectorLanes select(LaneMask mask, const VectorLanes& yes, const VectorLanes& no) {
  return {select(mask, yes.x, no.x), select(mask, yes.y, no.y), select(mask, yes.z, no.z)};
}

inline QuaternionLanes select(LaneMask mask, const QuaternionLanes& yes, const QuaternionLanes& no) {
  return {select(mask, yes.w, no.w), select(mask, yes.x, no.x), select(mask, yes.y, no.y), select(mask, yes.z, no.z)};
}

inline Lanes dot(const VectorLanes& a, const VectorLanes& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

inline VectorLanes cross(const VectorLanes& a, const VectorLanes& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

inline VectorLanes operator*(const MatrixLanes& A, const VectorLanes& v) {
  const auto& m = A.m;
  return {m[0][0] * v.x + m[0][1] * v.y + m[0][2] * v.z, m[1][0] * v.x + m[1][1] * v.y + m[1][2] * v.z,
          m[2][0] * v.x + m[2][1] * v.y + m[2][2] * v.z};
}

/// A + v wᵀ
inline void addOuter(MatrixLanes& A, const VectorLanes& v, const VectorLanes& w) {
  const Lanes rows[] = {v.x, v.y, v.z};
  for (int i = 0; i < 3; ++i) A.m[i][0] += rows[i] * w.x, A.m[i][1] += rows[i] * w.y, A.m[i][2] += rows[i] * w.z;
}

/// Size of the largest entry of each matrix.
inline Lanes largestEntries(const MatrixLanes& A) {
  Lanes largest = splat(0);
  for (const auto& row : A.m) {
    for (const Lanes& entry : row) largest = maximum(largest, absolute(entry));
  }
  return largest;
}

inline MatrixLanes zeroMatrices() {
  const Lanes zero = splat(0);
  return {{{zero, zero, zero}, {zero, zero, zero}, {zero, zero, zero}}};
}

inline MatrixLanes operator*(const MatrixLanes& A, const MatrixLanes& B) {
  MatrixLanes C;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) C.m[i][j] = A.m[i][0] * B.m[0][j] + A.m[i][1] * B.m[1][j] + A.m[i][2] * B.m[2][j];
  }
  return C;
}

inline VectorLanes operator*(const SymmetricLanes& A, const VectorLanes& v) {
  return {A.xx * v.x + A.xy * v.y + A.xz * v.z, A.xy * v.x + A.yy * v.y + A.yz * v.z,
          A.xz * v.x + A.yz * v.y + A.zz * v.z};
}

/// A + s v vᵀ
inline SymmetricLanes plusOuter(const SymmetricLanes& A, Lanes s, const VectorLanes& v) {
  const VectorLanes sv = s * v;
  return {A.xx + sv.x * v.x, A.xy + sv.x * v.y, A.xz + sv.x * v.z,
          A.yy + sv.y * v.y, A.yz + sv.y * v.z, A.zz + sv.z * v.z};
}

/// R − I, exactly zero for the identity.
inline MatrixLanes rotationChange(const QuaternionLanes& q) {
  const Lanes x2 = q.x + q.x, y2 = q.y + q.y, z2 = q.z + q.z;
  const Lanes xx = x2 * q.x, yy = y2 * q.y, zz = z2 * q.z, xy = x2 * q.y, xz = x2 * q.z, yz = y2 * q.z;
  const Lanes wx = x2 * q.w, wy = y2 * q.w, wz = z2 * q.w;
  return {{{-(yy + zz), xy - wz, xz + wy}, {xy + wz, -(xx + zz), yz - wx}, {xz - wy, yz + wx, -(xx + yy)}}};
}

inline MatrixLanes toMatrix(const QuaternionLanes& q) {
  MatrixLanes R = rotationChange(q);
  for (int i = 0; i < 3; ++i) R.m[i][i] += splat(1);
  return R;
}

inline QuaternionLanes normalized(const QuaternionLanes& q) {
  const Lanes s = splat(1) / squareRoot(q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z);
  return {s * q.w, s * q.x, s * q.y, s * q.z};
}

/// About where rotations will be that go on turning as they turned from `before` to `now`. Of quaternions with opposite
/// signs, `now`.
inline QuaternionLanes continued(const QuaternionLanes& now, const QuaternionLanes& before) {
  return normalized(
      {now.w + (now.w - before.w), now.x + (now.x - before.x), now.y + (now.y - before.y), now.z + (now.z - before.z)});
}

inline QuaternionLanes inverse(const QuaternionLanes& q) { return {q.w, -q.x, -q.y, -q.z}; }

/// The rotation a after b.
inline QuaternionLanes operator*(const QuaternionLanes& a, const QuaternionLanes& b) {
  return {a.w * b.w - (a.x * b.x + a.y * b.y + a.z * b.z), a.w * b.x + a.x * b.w + (a.y * b.z - a.z * b.y),
          a.w * b.y + a.y * b.w + (a.z * b.x - a.x * b.z), a.w * b.z + a.z * b.w + (a.x * b.y - a.y * b.x)};
}

/// q turned by a small w: (1 + w/2) q, whose length is 1 but for |w|²/8. Up to 1e-4 radians single precision does not
/// see that.
inline QuaternionLanes nudged(const QuaternionLanes& q, const VectorLanes& w) {
  const VectorLanes h = splat(0.5f) * w;
  return {q.w - (h.x * q.x + h.y * q.y + h.z * q.z), q.x + h.x * q.w + (h.y * q.z - h.z * q.y),
          q.y + h.y * q.w + (h.z * q.x - h.x * q.z), q.z + h.z * q.w + (h.x * q.y - h.y * q.x)};
}

/// The rotation by 2 atan(|w|/2) about w after q: the Cayley transform of w, equal to exp([w]×) to third order.
inline QuaternionLanes turned(const QuaternionLanes& q, const VectorLanes& w) { return normalized(nudged(q, w)); }

inline Lanes trace(const MatrixLanes& A) { return A.m[0][0] + A.m[1][1] + A.m[2][2]; }

/// tr(A B)
inline Lanes traceOfProduct(const MatrixLanes& A, const MatrixLanes& B) {
  Lanes rows[3];
  for (int i = 0; i < 3; ++i) rows[i] = A.m[i][0] * B.m[0][i] + A.m[i][1] * B.m[1][i] + A.m[i][2] * B.m[2][i];
  return rows[0] + rows[1] + rows[2];
}

inline Lanes traceOfProduct(const MatrixLanes& A, const SymmetricLanes& S) {
  const auto& a = A.m;
  return (a[0][0] * S.xx + a[1][1] * S.yy + a[2][2] * S.zz) +
         ((a[0][1] + a[1][0]) * S.xy + (a[0][2] + a[2][0]) * S.xz + (a[1][2] + a[2][1]) * S.yz);
}

inline MatrixLanes operator+(const SymmetricLanes& S, const MatrixLanes& A) {
  const auto& m = A.m;
  return {{{S.xx + m[0][0], S.xy + m[0][1], S.xz + m[0][2]},
           {S.xy + m[1][0], S.yy + m[1][1], S.yz + m[1][2]},
           {S.xz + m[2][0], S.yz + m[2][1], S.zz + m[2][2]}}};
}

inline void setMatrix(MatrixLanes& M, int lane, const Mat3& value) {
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) setLane(M.m[i][j], lane, static_cast<float>(value(i, j)));
  }
}

/// The symmetric part of a matrix.
inline void setSymmetric(SymmetricLanes& S, int lane, const Mat3& value) {
  const auto mean = [&](int i, int j) { return static_cast<float>(0.5 * (value(i, j) + value(j, i))); };
  setLane(S.xx, lane, mean(0, 0)), setLane(S.xy, lane, mean(0, 1)), setLane(S.xz, lane, mean(0, 2));
  setLane(S.yy, lane, mean(1, 1)), setLane(S.yz, lane, mean(1, 2)), setLane(S.zz, lane, mean(2, 2));
}

inline Mat3 matrixAt(const MatrixLanes& A, int lane) {
  Mat3 result;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) result(i, j) = A.m[i][j][lane];
  }
  return result;
}

inline Vec3 vectorAt(const VectorLanes& v, int lane) { return {v.x[lane], v.y[lane], v.z[lane]}; }

inline void setVector(VectorLanes& v, int lane, const Vec3& value) {
  setLane(v.x, lane, static_cast<float>(value.x()));
  setLane(v.y, lane, static_cast<float>(value.y()));
  setLane(v.z, lane, static_cast<float>(value.z()));
}

/// The rotation of one lane, orthonormal in double precision.
inline Mat3 rotationAt(const QuaternionLanes& q, int lane) {
  return Eigen::Quaterniond(q.w[lane], q.x[lane], q.y[lane], q.z[lane]).normalized().toRotationMatrix();
}

inline void setRotation(QuaternionLanes& q, int lane, const Mat3& R) {
  const Eigen::Quaterniond rotation(R);
  setLane(q.w, lane, static_cast<float>(rotation.w()));
  setLane(q.x, lane, static_cast<float>(rotation.x()));
  setLane(q.y, lane, static_cast<float>(rotation.y()));
  setLane(q.z, lane, static_cast<float>(rotation.z()));
}

inline QuaternionLanes identityRotations() { return {splat(1), splat(0), splat(0), splat(0)}; }

}  // namespace whittle
