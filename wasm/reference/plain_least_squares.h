#pragma once

#include <Eigen/SparseCholesky>
#include <initializer_list>
#include <utility>
#include <vector>

#include "base/sparse_matrix.h"
#include "base/types.h"

namespace whittle {

/// weight · ‖Σ F x − target‖² of a few points x.
struct PlainRow {
  double weight;
  std::initializer_list<std::pair<Index, Mat3>> factors;  // point and F
  Vec3 target = Vec3::Zero();
};

inline double plainEnergy(const PlainRow& row, const Points& points) {
  Vec3 residual = -row.target;
  for (const auto& [x, F] : row.factors) residual += F * points.row(x).transpose();
  return row.weight * residual.squaredNorm();
}

/// Least squares in points by normal equations and Eigen's Cholesky factorization: the pattern is analyzed the first
/// time, everything else is done anew for every solve.
class PlainLeastSquares {
 public:
  explicit PlainLeastSquares(Index points) : rhs_(Scalars::Zero(3 * points)), matrix_(3 * points, 3 * points) {}

  void clear() {
    entries_.clear();
    rhs_.setZero();
  }
  /// @param keepsZeros whether entries that are zero now may be others next time
  void add(const PlainRow& row, bool keepsZeros) {
    for (const auto& [a, Fa] : row.factors) {
      rhs_.segment<3>(3 * a) += row.weight * Fa.transpose() * row.target;
      for (const auto& [b, Fb] : row.factors) {
        if (a < b) continue;  // the lower triangle is enough
        const Mat3 block = row.weight * Fa.transpose() * Fb;
        for (int i = 0; i < 3; ++i) {
          for (int j = 0; j < 3; ++j) {
            if (keepsZeros || block(i, j) != 0) entries_.emplace_back(3 * a + i, 3 * b + j, block(i, j));
          }
        }
      }
    }
  }
  void assemble() { matrix_.setFromTriplets(entries_.begin(), entries_.end()); }
  /// Returns whether the matrix was positive definite.
  bool factorize() {
    if (!isAnalyzed_) cholesky_.analyzePattern(matrix_);
    isAnalyzed_ = true;
    cholesky_.factorize(matrix_);
    return cholesky_.info() == Eigen::Success;
  }
  Points solve() const {
    const Scalars solution = cholesky_.solve(rhs_);
    return Eigen::Map<const Points>(solution.data(), solution.size() / 3, 3);
  }

  /// The matrix; its lower triangle is what counts.
  const SparseMatrix& matrix() const { return matrix_; }
  const Scalars& rightHandSide() const { return rhs_; }

 private:
  std::vector<Eigen::Triplet<double, Index>> entries_;
  Scalars rhs_;
  SparseMatrix matrix_;
  Eigen::SimplicialLDLT<SparseMatrix, Eigen::Lower, Eigen::AMDOrdering<Index>> cholesky_;
  bool isAnalyzed_ = false;
};

}  // namespace whittle
