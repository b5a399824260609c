#include "methods/plastic/plastic_field.h"

#include <cmath>

namespace whittle {

namespace {

/// Below this angle series replace quotients of differences.
constexpr double kSmallAngle = 1e-4;

}  // namespace

Mat3 crossMatrix(const Vec3& a) {
  Mat3 cross;
  cross << 0, -a.z(), a.y(), a.z(), 0, -a.x(), -a.y(), a.x(), 0;
  return cross;
}

Mat3 rotationOf(const Vec3& vector) {
  const double angle = vector.norm();
  if (angle == 0) return Mat3::Identity();
  return Eigen::AngleAxisd(angle, vector / angle).toRotationMatrix();
}

Mat3 leftJacobian(const Vec3& vector) {
  const double angle = vector.norm(), squared = angle * angle;
  const bool isSmall = angle < kSmallAngle;
  const double first = isSmall ? 0.5 - squared / 24 : (1 - std::cos(angle)) / squared;
  const double second = isSmall ? 1.0 / 6 - squared / 120 : (angle - std::sin(angle)) / (squared * angle);
  const Mat3 cross = crossMatrix(vector);
  return Mat3::Identity() + first * cross + second * cross * cross;
}

PlasticField PlasticField::identity(Index faces) {
  return {std::vector<Vec3>(faces, Vec3::Zero()), std::vector<Mat2>(faces, Mat2::Identity())};
}

void PlasticField::add(const Scalars& change, double share) {
  for (Index f = 0; f < size(); ++f) {
    rotations[f] += share * change.segment<3>(3 * f);
    stretches[f] += share * stretchOf(stretchNumbers(change, size(), f));
  }
}

Mat2 stretchOf(const Vec3& numbers) {
  Mat2 stretch;
  stretch << numbers[0] + numbers[1], numbers[2], numbers[2], numbers[0] - numbers[1];
  return stretch / std::sqrt(2.0);
}

Vec3 stretchNumbers(const Scalars& field, Index faces, Index face) {
  return {field[3 * faces + face], field[4 * faces + 2 * face], field[4 * faces + 2 * face + 1]};
}

const std::array<Mat2, 3>& stretchBasis() {
  static const std::array<Mat2, 3> basis = {stretchOf(Vec3::UnitX()), stretchOf(Vec3::UnitY()),
                                            stretchOf(Vec3::UnitZ())};
  return basis;
}

}  // namespace whittle
