#include "optimization/pseudo_inverse.h"

#include <Eigen/Eigenvalues>

namespace whittle {

Eigen::MatrixXd pseudoInverse(const Eigen::MatrixXd& a, double share) {
  if (a.size() == 0) return a;
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen((a + a.transpose()) / 2);
  const Scalars& values = eigen.eigenvalues();
  const double least = share * values.cwiseAbs().maxCoeff();
  Scalars inverse(values.size());
  for (Index i = 0; i < inverse.size(); ++i) inverse[i] = values[i] > least ? 1 / values[i] : 0;
  return eigen.eigenvectors() * inverse.asDiagonal() * eigen.eigenvectors().transpose();
}

}  // namespace whittle
