#pragma once

#include <array>

#include "methods/local_global/cubic/cubic_vertex.h"
#include "methods/values/choice.h"

namespace whittle {

/// A polyhedral style (2019, §4): the regularizer κ Σ_j l_j |b_j · R n| is the support function of the zonotope with
/// edges l_j b_j, whose faces the shape takes on. Always centrally symmetric.
struct Polyhedron {
  static constexpr Index kMostRows = 12;
  enum class Name { cube, hexagonalPrism, rhombicDodecahedron, truncatedOctahedron };

  Index rowCount = 0;
  std::array<Vec3, kMostRows> rows;       // b_j, unit
  std::array<double, kMostRows> lengths;  // l_j

  /// What people call them, the cube first.
  static Choices<Name> names();
  /// Lengths are such that a given λ pulls about as strongly as with the cube: Σ l_j = 3.
  static Polyhedron named(Name name);
  /// A box, its edges along the axes; one of length 0 is none.
  static Polyhedron box(const Vec3& lengths);
  /// The rows of a matrix B (#rows×3), no more than `kMostRows` and none of zeros: l_j b_j as they are.
  static Polyhedron ofRows(const Points& rows);

  double support(const Vec3& s) const;
  /// Σ_k κ_k Σ_j l_j |b_j · R n_k|
  double regularizer(FanNormals normals, const Mat3& R) const;
};

/// One vertex of the local step with the normals of its smooth fans: max_R tr(R M) − Σ_k κ_k Σ_j l_j |b_j · R n_k|.
struct FanVertex {
  Mat3 M;
  FanNormals normals;
  const Polyhedron& polyhedron;

  double objective(const Mat3& R) const {
    return R.cwiseProduct(M.transpose()).sum() - polyhedron.regularizer(normals, R);
  }
};

/// One vertex of one normal for any polyhedron: max_R tr(R M) − κ Σ_j l_j |b_j · R n|.
struct PolyhedralVertex {
  Mat3 M;
  Vec3 n;         // unit
  double weight;  // κ
  Polyhedron polyhedron;

  explicit PolyhedralVertex(const CubicVertex& cubic);
  PolyhedralVertex(const Mat3& M, const Vec3& n, double weight, const Polyhedron& polyhedron)
      : M(M), n(n), weight(weight), polyhedron(polyhedron) {}

  double objective(const Mat3& R) const {
    return R.cwiseProduct(M.transpose()).sum() - weight * polyhedron.support(R * n);
  }
  /// M − κ n yᵀ with y = Σ_j l_j u_j b_j, u_j = ±1 the signs of b_j · s.
  Mat3 pulledAt(const Vec3& s) const;
};

}  // namespace whittle
