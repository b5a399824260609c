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

Mat3 plainCubic(Mat3 M, std::vector<PlainNormal> normals, const AdmmConstants& constants, std::span<AdmmState> states) {
  const double root3 = std::sqrt(3.0);
  double weight = 0;
  for (const PlainNormal& normal : normals) weight += normal.weight;
  if (constants.scaled && weight > 0) {
    M /= weight;
    for (PlainNormal& normal : normals) normal.weight /= weight;
  }
  double& rho = states[0].penalty;
  if (rho == 0) rho = constants.penalty;
  Mat3 R = Mat3::Identity();
  for (int step = 0; step < constants.cap; ++step) {
    Mat3 target = M;
    for (std::size_t k = 0; k < normals.size(); ++k)
      target += rho * normals[k].n * (states[k].z - states[k].u).transpose();
    R = plainRotation(target);
    double primal = 0, dual = 0, turned = 0, split = 0, scaledDual = 0;  // squared, of all normals
    for (std::size_t k = 0; k < normals.size(); ++k) {
      auto& [z, u, unused] = states[k];
      const Vec3 before = z, p = R * normals[k].n, v = p + u;
      z = v.array().sign() * (v.array().abs() - normals[k].weight / rho).max(0.0);
      u += p - z;
      primal += (z - p).squaredNorm(), dual += (z - before).squaredNorm();
      turned += p.squaredNorm(), split += z.squaredNorm(), scaledDual += u.squaredNorm();
    }
    primal = std::sqrt(primal), dual = rho * std::sqrt(dual);
    const double primalLimit = root3 * constants.absolute + constants.relative * std::sqrt(std::max(turned, split));
    const double dualLimit = root3 * constants.absolute + constants.relative * rho * std::sqrt(scaledDual);
    if (primal <= primalLimit && dual <= dualLimit) break;
    const double factor = primal > 10 * dual ? 2 : dual > 10 * primal ? 0.5 : 1;
    rho *= factor;
    for (AdmmState& state : states) state.u /= factor;
  }
  return R;
}

}  // namespace whittle
