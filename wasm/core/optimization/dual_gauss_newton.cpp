#include "optimization/dual_gauss_newton.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

namespace whittle {

namespace {

/// Combinations of free unknowns whose effect is a smaller share of the largest are none.
constexpr double kNoEffect = 1e-10;

/// a⁺ b for a symmetric positive semidefinite a.
Scalars solveSemidefinite(const Eigen::MatrixXd& a, const Scalars& b) {
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(a);
  const Scalars& values = eigen.eigenvalues();
  Scalars parts = eigen.eigenvectors().transpose() * b;
  for (Index i = 0; i < parts.size(); ++i)
    parts[i] = values[i] > kNoEffect * values.cwiseAbs().maxCoeff() ? parts[i] / values[i] : 0;
  return eigen.eigenvectors() * parts;
}

}  // namespace

Status solveDual(const Eigen::MatrixXd& JW, const Scalars& target, const Eigen::MatrixXd& G, DualStep& step) {
  const Index rows = static_cast<Index>(target.size());
  const Eigen::MatrixXd M = Eigen::MatrixXd::Identity(rows, rows) + (JW + JW.transpose()) / 2;
  const Eigen::LLT<Eigen::MatrixXd> factor(M);
  step.free.setZero(G.cols());
  step.multipliers = factor.solve(target);
  if (G.cols() > 0) {
    const Eigen::MatrixXd MG = factor.solve(G);
    step.free = solveSemidefinite(G.transpose() * MG, MG.transpose() * target);
    step.multipliers -= MG * step.free;
  }
  if (factor.info() == Eigen::Success && step.multipliers.allFinite() && step.free.allFinite()) return {};
  return Status::failure(Code::numericalFailure,
                         "the landmarks give a system that cannot be solved; move them less far or remove some");
}

}  // namespace whittle
