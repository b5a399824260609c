#include "methods/plastic/shell_system.h"

#include <algorithm>

namespace whittle {

namespace {

/// What remains of hinges that nothing bends, as where parts meet in a single vertex, as a share of the usual stiffness.
constexpr double kLeastStiffness = 1e-9;
constexpr ConjugateGradients::Limits kSolve{1e-6, 10};

double medianDiagonal(const SparseMatrix& matrix) {
  std::vector<double> diagonal(matrix.cols());
  for (Index i = 0; i < matrix.cols(); ++i) diagonal[i] = matrix.coeff(i, i);
  if (diagonal.empty()) return 1;
  const auto middle = diagonal.begin() + static_cast<std::ptrdiff_t>(diagonal.size() / 2);
  std::nth_element(diagonal.begin(), middle, diagonal.end());
  return *middle;
}

}  // namespace

void ShellSystem::shape(const Shell& shell, std::vector<Index> nodeOf) {
  stiffness_ = Stiffness(shell, std::move(nodeOf));
  coordinates_.resize(stiffness_.nodes(), 3);
  for (std::size_t v = 0; v < this->nodeOf().size(); ++v) {
    if (this->nodeOf()[v] >= 0)
      coordinates_.row(this->nodeOf()[v]) = shell.input().positions.row(static_cast<Index>(v));
  }
  cholesky_.beginAnalyze(stiffness_.matrix(), {.coordinates = &coordinates_, .blockSize = 3});
}

void ShellSystem::beginFactorize(const Shell& shell, const RigidModes& modes) {
  modes_ = &modes;
  stiffness_.assemble(shell);
  const double usual = medianDiagonal(stiffness_.matrix());
  modes.addSupports(usual, stiffness_);
  for (Index node = 0; node < stiffness_.nodes(); ++node)
    stiffness_.add(node, kLeastStiffness * usual * Mat3::Identity());
  cholesky_.beginFactorize(stiffness_.matrix(), true);
}

Status ShellSystem::factorizeNext(double& share) { return cholesky_.factorizeNext(share); }

void ShellSystem::approximate(Rows& b) {
  modes_->takeOut(b);
  cholesky_.solve(b);
  modes_->takeOut(b);
}

Status ShellSystem::solve(Rows& B) {
  modes_->takeOut(B);
  solution_.setZero(B.rows(), B.cols());
  const Status status = cholesky_.solveRefined(stiffness_.matrix(), B, solution_, kSolve);
  modes_->takeOut(solution_);
  B = solution_;
  return status;
}

void ShellSystem::gather(const Points& ofVertices, Scalars& ofNodes) const {
  ofNodes.resize(unknowns());
  for (std::size_t v = 0; v < nodeOf().size(); ++v) {
    if (nodeOf()[v] >= 0) ofNodes.segment<3>(3 * nodeOf()[v]) = ofVertices.row(static_cast<Index>(v)).transpose();
  }
}

void ShellSystem::scatter(const Scalars& ofNodes, Points& ofVertices) const {
  ofVertices.setZero(static_cast<Index>(nodeOf().size()), 3);
  for (std::size_t v = 0; v < nodeOf().size(); ++v) {
    if (nodeOf()[v] >= 0) ofVertices.row(static_cast<Index>(v)) = ofNodes.segment<3>(3 * nodeOf()[v]).transpose();
  }
}

}  // namespace whittle
