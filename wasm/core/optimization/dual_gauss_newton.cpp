#include "optimization/dual_gauss_newton.h"

#include <Eigen/Cholesky>

#include "optimization/pseudo_inverse.h"

namespace whittle {

namespace {

/// Combinations of free unknowns whose effect is a smaller share of the largest are none.
constexpr double kNoEffect = 1e-10;

}  // namespace

Status solveDual(const Eigen::MatrixXd& JW, const Scalars& target, const Eigen::MatrixXd& G, DualStep& step) {
  const Index rows = static_cast<Index>(target.size());
  const Eigen::MatrixXd M = Eigen::MatrixXd::Identity(rows, rows) + (JW + JW.transpose()) / 2;
  const Eigen::LLT<Eigen::MatrixXd> factor(M);
  step.free.setZero(G.cols());
  step.multipliers = factor.solve(target);
  if (G.cols() > 0) {
    const Eigen::MatrixXd MG = factor.solve(G);
    step.free = pseudoInverse(G.transpose() * MG, kNoEffect) * (MG.transpose() * target);
    step.multipliers -= MG * step.free;
  }
  if (factor.info() == Eigen::Success && step.multipliers.allFinite() && step.free.allFinite()) return {};
  return Status::failure(Code::numericalFailure,
                         "the landmarks give a system that cannot be solved; move them less far or remove some");
}

}  // namespace whittle
