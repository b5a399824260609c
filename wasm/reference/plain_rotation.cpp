#include "reference/plain_rotation.h"

#include <Eigen/SVD>
#include <algorithm>
#include <cmath>

namespace whittle {

Mat3 plainRotation(const Mat3& M) {
  const Eigen::JacobiSVD<Mat3> svd(M, Eigen::ComputeFullU | Eigen::ComputeFullV);
  Mat3 V = svd.matrixV();
  // A reflection is turned into the best rotation along the direction that matters least.
  if ((V * svd.matrixU().transpose()).determinant() < 0) V.col(2) *= -1;
  return V * svd.matrixU().transpose();
}

Mat3 plainCubic(Mat3 M, const Vec3& n, double weight, const AdmmConstants& constants, AdmmState& state) {
  const double root3 = std::sqrt(3.0);
  if (constants.scaled && weight > 0) {
    M /= weight;
    weight = 1;
  }
  auto& [z, u, rho] = state;
  if (rho == 0) rho = constants.penalty;
  Mat3 R = Mat3::Identity();
  for (int step = 0; step < constants.cap; ++step) {
    R = plainRotation(M + rho * n * (z - u).transpose());
    const Vec3 before = z;
    const Vec3 v = R * n + u;
    z = v.array().sign() * (v.array().abs() - weight / rho).max(0.0);
    u += R * n - z;

    const double primal = (z - R * n).norm();
    const double dual = rho * (z - before).norm();
    const double primalLimit = root3 * constants.absolute + constants.relative * std::max((R * n).norm(), z.norm());
    const double dualLimit = root3 * constants.absolute + constants.relative * (rho * u).norm();
    if (primal <= primalLimit && dual <= dualLimit) break;
    if (primal > 10 * dual) {
      rho *= 2;
      u /= 2;
    } else if (dual > 10 * primal) {
      rho /= 2;
      u *= 2;
    }
  }
  return R;
}

}  // namespace whittle
