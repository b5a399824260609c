#pragma once

#include "base/types.h"
#include "optimization/low_rank_inverse.h"

namespace whittle {

/// Conjugate gradients for M λ + G ω = y, Gᵀ λ = 0: the dual step (`solveDual`) where M is only known by what it makes of
/// vectors. The caller multiplies: `direction` is to be multiplied by M, and `advance` takes the product.
class ConstrainedDescent {
 public:
  struct Limits {
    double residual = 1e-2;  // as a share of the first
    int iterations = 100;
  };

  /// @param inverse an approximation of M⁻¹, kept by the caller
  /// @param G #rows×#free, or without columns; kept as well
  void begin(const Scalars& y, const Eigen::MatrixXd& G, const LowRankInverse& inverse, const Limits& limits);
  bool isDone() const { return isDone_; }
  int iterations() const { return iterations_; }

  const Scalars& direction() const { return direction_; }
  void advance(const Scalars& image);

  const Scalars& multipliers() const { return multipliers_; }
  /// ω for the λ that there is.
  Scalars free() const;

 private:
  Scalars precondition(const Scalars& residual) const;

  const LowRankInverse* inverse_ = nullptr;
  const Eigen::MatrixXd* G_ = nullptr;
  Limits limits_;
  Eigen::MatrixXd inverseG_, schur_;  // P⁻¹ G; (Gᵀ P⁻¹ G)⁺
  Scalars multipliers_, residual_, direction_;
  double energy_ = 0, first_ = 0;  // rᵀ z now and at the start
  int iterations_ = 0;
  bool isDone_ = true;
};

}  // namespace whittle
