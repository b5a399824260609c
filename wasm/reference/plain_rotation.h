#pragma once

#include <span>
#include <vector>

#include "base/types.h"

namespace whittle {

/// The rotation that maximises tr(R M), by Eigen's Jacobi SVD: orthogonal Procrustes as the papers have it.
Mat3 plainRotation(const Mat3& M);

/// Constants of the scaled ADMM of Cubic Stylization (2019, §3.1), as printed.
struct AdmmConstants {
  double penalty = 1e-4;   // ρ at the start
  double absolute = 1e-5;  // ε_abs
  double relative = 1e-3;  // ε_rel
  int cap = 100;
  /// Whether M and λ a are divided by λ a first, so that penalty and tolerances mean the same for every area.
  bool scaled = false;

  /// Iterates to the optimum, within rounding: for comparing minima, not for timing.
  static AdmmConstants tight() { return {5, 1e-11, 1e-11, 3000, true}; }
};

/// What ADMM keeps of a normal from one outer iteration to the next.
struct AdmmState {
  Vec3 z = Vec3::Zero();  // stands for R n
  Vec3 u = Vec3::Zero();  // scaled dual
  double penalty = 0;     // ρ, of a vertex's first normal for all; 0 before the first call
};

/// A normal of a vertex, one for each smooth fan of its faces, and its weight λ a.
struct PlainNormal {
  Vec3 n;
  double weight;
};

/// max_R tr(R M) − Σ_k weight_k |R n_k|₁ by ADMM; where the steps run out, the rotation of the last. Of one normal it is
/// the printed step.
/// @param states one for each normal
Mat3 plainCubic(Mat3 M, std::vector<PlainNormal> normals, const AdmmConstants& constants, std::span<AdmmState> states);

}  // namespace whittle
