#pragma once

#include <vector>

#include "geometry/fundamental_forms.h"

namespace whittle {

/// exp of the cross product with a vector: the rotation about it by its length.
Mat3 rotationOf(const Vec3& vector);
/// How the rotation of a vector v turns when v changes: exp(v + dv) = exp(J dv) exp(v) to first order.
Mat3 leftJacobian(const Vec3& vector);
/// The matrix of a × ….
Mat3 crossMatrix(const Vec3& a);

/// What is asked of each face lastingly, its plastic degrees of freedom: a rotation exp(θ) and a stretch S, a symmetric
/// 2×2 matrix in the face's frame.
///
/// As numbers they are 6 a face: first θ of all faces (xyz), then tr S of all, then S₁₁ − S₂₂ and 2 S₁₂ of all, those of
/// S divided by √2, so that lengths of such vectors are Frobenius norms.
struct PlasticField {
  std::vector<Vec3> rotations;  // θ
  std::vector<Mat2> stretches;  // S

  static PlasticField identity(Index faces);
  Index size() const { return static_cast<Index>(stretches.size()); }

  /// Adds a share of a change, 6 #F numbers.
  void add(const Scalars& change, double share);
};

/// The stretch whose three numbers are given, and where those of a face stand among the 6 `faces`.
Mat2 stretchOf(const Vec3& numbers);
Vec3 stretchNumbers(const Scalars& field, Index faces, Index face);
/// The matrices of the three numbers, which are orthonormal.
const std::array<Mat2, 3>& stretchBasis();

}  // namespace whittle
