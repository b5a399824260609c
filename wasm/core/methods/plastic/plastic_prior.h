#pragma once

#include "linear/sparse_cholesky.h"
#include "methods/plastic/shell.h"

namespace whittle {

/// How much plastic change is worth: qᵀ A q with A = α LᵀL + β M for fields q as `PlasticField` lays them out. L is the
/// Laplacian over neighbouring faces, by lengths and areas instead of by their number, so that it does not depend on how
/// the surface is cut; stretches of neighbours are compared with one unfolded into the plane of the other (Fig. 7). M are
/// areas. θ and tr S have one matrix of #F unknowns for their four numbers, the rest of S one of 2 #F. Neither ever
/// changes for a mesh, α and β.
class PlasticPrior {
 public:
  /// Columns of numbers, row after row.
  using Rows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

  /// Takes a shell at rest; `prepareNext` analyzes and factors, slice by slice.
  /// @param beta 0: growth the same all over a part is free, see `growth`
  void shape(const Shell& shell, double alpha, double beta);
  Status prepareNext(double& share);

  /// qᵀ A q.
  double energy(const Scalars& field) const;

  /// Where β is 0, of each part the change that is free: the same tr S on all of its faces, 6 #F numbers a column.
  const Eigen::MatrixXd& growth() const { return growth_; }

  /// Begins to overwrite columns (6 #F×k) with A⁻¹ times them; where β is 0, with what is orthogonal to free growth. Kept
  /// by the caller until the end.
  /// @param isRough as well as a search direction needs it
  void beginSolve(Rows& columns, bool isRough = false);
  /// Does a slice; `isDone` says whether it was the last.
  Status solveNext(bool& isDone);

 private:
  void weigh(const Shell& shell);
  void assemble(const Shell& shell, double beta);
  void ground(const Shell& shell);
  void takeOffGrowth(bool areLoads);

  Index faces_ = 0;
  double alpha_ = 1;
  Scalars masses_;                                // M, #F, 1 on average
  std::vector<std::array<double, 3>> couplings_;  // w of each side
  SparseMatrix scalar_, deviator_;
  Points centers_;
  Eigen::MatrixXd growth_;
  std::vector<Index> grounds_;  // faces that are held where β is 0
  SparseCholesky scalarFactor_, deviatorFactor_;
  int stage_ = 0;

  // While columns are solved
  Rows* columns_ = nullptr;
  bool isRough_ = false;
  Index next_ = 0;
  Rows rhs_, solution_;
};

/// The mean length of the sides of a mesh's faces.
double meanSide(const Shell& shell);

}  // namespace whittle
