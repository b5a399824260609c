#include "linear/sparse_cholesky.h"

namespace whittle {

namespace {

/// x ← L⁻¹ x, column by column; the diagonal is the first entry of each.
void solveForward(const SparseMatrix& L, Points& x) {
  const Index* start = L.outerIndexPtr();
  const Index* row = L.innerIndexPtr();
  const double* value = L.valuePtr();
  for (Index j = 0; j < L.cols(); ++j) {
    const Eigen::RowVector3d xj = x.row(j) / value[start[j]];
    x.row(j) = xj;
    for (Index p = start[j] + 1; p < start[j + 1]; ++p) x.row(row[p]) -= value[p] * xj;
  }
}

/// x ← L⁻ᵀ x.
void solveBackward(const SparseMatrix& L, Points& x) {
  const Index* start = L.outerIndexPtr();
  const Index* row = L.innerIndexPtr();
  const double* value = L.valuePtr();
  for (Index j = static_cast<Index>(L.cols()) - 1; j >= 0; --j) {
    Eigen::RowVector3d xj = x.row(j);
    for (Index p = start[j] + 1; p < start[j + 1]; ++p) xj -= value[p] * x.row(row[p]);
    x.row(j) = xj / value[start[j]];
  }
}

}  // namespace

void SparseCholesky::analyze(const SparseMatrix& A) {
  llt_.analyzePattern(A);
  permuted_.resize(A.rows(), 3);
}

Status SparseCholesky::factorize(const SparseMatrix& A) {
  llt_.factorize(A);
  if (llt_.info() == Eigen::Success) return {};
  return Status::failure(Code::numericalFailure,
                         "the linear system is not positive definite; the mesh may hold faces too thin to compute with");
}

void SparseCholesky::solve(Points& rhs) {
  const SparseMatrix& L = llt_.matrixL().nestedExpression();
  const auto& order = llt_.permutationP().indices();
  for (Index i = 0; i < rhs.rows(); ++i) permuted_.row(order[i]) = rhs.row(i);
  solveForward(L, permuted_);
  solveBackward(L, permuted_);
  for (Index i = 0; i < rhs.rows(); ++i) rhs.row(i) = permuted_.row(order[i]);
}

}  // namespace whittle
