#pragma once

#include "base/lanes.h"
#include "base/types.h"

namespace whittle {

/// Four vectors, four 3×3 matrices (row by row), four rotations, four symmetric matrices: one in each lane.
struct VectorLanes {
  Lanes x, y, z;
};

struct MatrixLanes {
  Lanes m[3][3];
};

/// Covariances are kept in double precision: energies are their small differences.
struct CovarianceLanes {
  DoubleLanes m[3][3];
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

/// How many batches of four hold so many elements; the last one is filled up with elements that stand for nothing.
inline std::size_t batchCount(Index elements) { return (static_cast<std::size_t>(elements) + 3) / 4; }

inline VectorLanes operator+(const VectorLanes& a, const VectorLanes& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline VectorLanes operator-(const VectorLanes& a, const VectorLanes& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline VectorLanes operator*(Lanes s, const VectorLanes& a) { return {s * a.x, s * a.y, s * a.z}; }
inline VectorLanes keep(LaneMask mask, const VectorLanes& a) { return {keep(mask, a.x), keep(mask, a.y), keep(mask, a.z)}; }

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

inline MatrixLanes operator*(const MatrixLanes& A, const MatrixLanes& B) {
  MatrixLanes C;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) C.m[i][j] = A.m[i][0] * B.m[0][j] + A.m[i][1] * B.m[1][j] + A.m[i][2] * B.m[2][j];
  }
  return C;
}

inline VectorLanes operator*(const SymmetricLanes& A, const VectorLanes& v) {
  return {A.xx * v.x + A.xy * v.y + A.xz * v.z, A.xy * v.x + A.yy * v.y + A.yz * v.z, A.xz * v.x + A.yz * v.y + A.zz * v.z};
}

/// A + s v vᵀ
inline SymmetricLanes plusOuter(const SymmetricLanes& A, Lanes s, const VectorLanes& v) {
  const VectorLanes sv = s * v;
  return {A.xx + sv.x * v.x, A.xy + sv.x * v.y, A.xz + sv.x * v.z, A.yy + sv.y * v.y, A.yz + sv.y * v.z, A.zz + sv.z * v.z};
}

/// R − I, exactly zero for the identity.
inline MatrixLanes turnOf(const QuaternionLanes& q) {
  const Lanes x2 = q.x + q.x, y2 = q.y + q.y, z2 = q.z + q.z;
  const Lanes xx = x2 * q.x, yy = y2 * q.y, zz = z2 * q.z, xy = x2 * q.y, xz = x2 * q.z, yz = y2 * q.z;
  const Lanes wx = x2 * q.w, wy = y2 * q.w, wz = z2 * q.w;
  return {{{-(yy + zz), xy - wz, xz + wy}, {xy + wz, -(xx + zz), yz - wx}, {xz - wy, yz + wx, -(xx + yy)}}};
}

/// s R − I for a scale s = 1 + growth, exactly zero for the identity without growth.
inline MatrixLanes turnOf(const QuaternionLanes& q, Lanes growth) {
  MatrixLanes turn = turnOf(q);
  for (auto& row : turn.m) {
    for (Lanes& entry : row) entry += growth * entry;
  }
  for (int i = 0; i < 3; ++i) turn.m[i][i] += growth;
  return turn;
}

inline MatrixLanes toMatrix(const QuaternionLanes& q) {
  MatrixLanes R = turnOf(q);
  for (int i = 0; i < 3; ++i) R.m[i][i] += splat(1);
  return R;
}

inline QuaternionLanes normalized(const QuaternionLanes& q) {
  const Lanes s = splat(1) / squareRoot(q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z);
  return {s * q.w, s * q.x, s * q.y, s * q.z};
}

/// About where rotations will be that go on turning as they turned from `before` to `now`. Of quaternions with opposite signs, `now`.
inline QuaternionLanes continued(const QuaternionLanes& now, const QuaternionLanes& before) {
  return normalized({now.w + (now.w - before.w), now.x + (now.x - before.x), now.y + (now.y - before.y), now.z + (now.z - before.z)});
}

inline QuaternionLanes inverse(const QuaternionLanes& q) { return {q.w, -q.x, -q.y, -q.z}; }

/// The rotation a after b.
inline QuaternionLanes operator*(const QuaternionLanes& a, const QuaternionLanes& b) {
  return {a.w * b.w - (a.x * b.x + a.y * b.y + a.z * b.z), a.w * b.x + a.x * b.w + (a.y * b.z - a.z * b.y),
          a.w * b.y + a.y * b.w + (a.z * b.x - a.x * b.z), a.w * b.z + a.z * b.w + (a.x * b.y - a.y * b.x)};
}

/// The rotation by 2 atan(|w|/2) about w after q: the Cayley transform of w, equal to exp([w]×) to third order.
inline QuaternionLanes turned(const QuaternionLanes& q, const VectorLanes& w) {
  const VectorLanes h = splat(0.5f) * w;
  const QuaternionLanes t{q.w - (h.x * q.x + h.y * q.y + h.z * q.z), q.x + h.x * q.w + (h.y * q.z - h.z * q.y),
                          q.y + h.y * q.w + (h.z * q.x - h.x * q.z), q.z + h.z * q.w + (h.x * q.y - h.y * q.x)};
  return normalized(t);
}

inline MatrixLanes toSingle(const CovarianceLanes& M) {
  MatrixLanes result;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) result.m[i][j] = toSingle(M.m[i][j]);
  }
  return result;
}

/// tr(R M), as exact in q as double precision has it (q need not be of unit length).
inline DoubleLanes traces(const QuaternionLanes& q, const CovarianceLanes& M) {
  const auto& m = M.m;
  const DoubleLanes w = toDouble(q.w), x = toDouble(q.x), y = toDouble(q.y), z = toDouble(q.z);
  const DoubleLanes ww = w * w, xx = x * x, yy = y * y, zz = z * z;
  const DoubleLanes diagonal = m[0][0] * (ww + xx - yy - zz) + m[1][1] * (ww - xx + yy - zz) + m[2][2] * (ww - xx - yy + zz);
  const DoubleLanes even = x * y * (m[0][1] + m[1][0]) + x * z * (m[0][2] + m[2][0]) + y * z * (m[1][2] + m[2][1]);
  const DoubleLanes odd = x * (m[1][2] - m[2][1]) + y * (m[2][0] - m[0][2]) + z * (m[0][1] - m[1][0]);
  return (diagonal + 2 * (even + w * odd)) / (ww + xx + yy + zz);
}

inline void setMatrix(CovarianceLanes& M, int lane, const Mat3& value) {
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) M.m[i][j][lane] = value(i, j);
  }
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
  v.x[lane] = static_cast<float>(value.x());
  v.y[lane] = static_cast<float>(value.y());
  v.z[lane] = static_cast<float>(value.z());
}

/// The rotation of one lane, orthonormal in double precision.
inline Mat3 rotationAt(const QuaternionLanes& q, int lane) {
  return Eigen::Quaterniond(q.w[lane], q.x[lane], q.y[lane], q.z[lane]).normalized().toRotationMatrix();
}

inline void setRotation(QuaternionLanes& q, int lane, const Mat3& R) {
  const Eigen::Quaterniond rotation(R);
  q.w[lane] = static_cast<float>(rotation.w());
  q.x[lane] = static_cast<float>(rotation.x());
  q.y[lane] = static_cast<float>(rotation.y());
  q.z[lane] = static_cast<float>(rotation.z());
}

inline QuaternionLanes identityRotations() { return {splat(1), splat(0), splat(0), splat(0)}; }

}  // namespace whittle
