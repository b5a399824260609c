#pragma once

#include "methods/plastic/shell.h"

namespace whittle {

/// The derivative of the gradient of a shell's energy, in its present shape, with respect to its plastic degrees of
/// freedom: f_p, exact, in factors of a few numbers a face and side. Fields are laid out as `PlasticField` says.
class Sensitivity {
 public:
  /// Columns of numbers, row after row.
  using Rows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

  /// Finds the factors. The shell is kept by the caller, in this shape, as long as this is used.
  void take(const Shell& shell);

  /// f_p Q: how forces (3 #V×k) change with changes of what is plastic.
  /// @param changes 6 #F×k
  /// @param forces out
  void apply(const Rows& changes, Rows& forces) const;

  /// f_pᵀ Y.
  /// @param Y 3 #V×k, displacements of the vertices
  /// @param result out, 6 #F×k
  void applyTransposed(const Rows& Y, Rows& result) const;

 private:
  /// Symmetric 2×2 matrices A as three numbers, (A₁₁, 2 A₁₂, A₂₂) where they are derivatives: so that A : B is the
  /// product with (B₁₁, B₁₂, B₂₂).
  struct FaceFactors {
    Mat3 membrane;               // dσ by the three numbers of S, a column each
    Mat3 moment;                 // dμ by them
    std::array<Mat3, 3> turned;  // half of what a turn of the face against a neighbour takes off: (·) db = …
    Mat3 jacobian;               // of its rotation
  };

  void setStretchFactors(const Shell& shell, Index face, FaceFactors& factors) const;
  void setTurnFactors(const Shell& shell, Index face, FaceFactors& factors) const;

  const Shell* shell_ = nullptr;
  std::vector<FaceFactors> factors_;
};

}  // namespace whittle
