#include "methods/plastic/alignment.h"

#include <cmath>

#include "geometry/rotation_fit.h"
#include "methods/plastic/held_points.h"

namespace whittle {

namespace {

/// A singular value that is a smaller share of the first says nothing about a turn.
constexpr double kNoDirection = 1e-6;

Vec3 meanOf(const std::vector<Vec3>& points) {
  Vec3 mean = Vec3::Zero();
  for (const Vec3& point : points) mean += point / static_cast<double>(points.size());
  return mean;
}

/// The rotation R for which tr(Rᵀ H) is largest; of several the least.
Mat3 nearestRotation(const Mat3& H) {
  Mat3 cofactors;
  for (int i = 0; i < 3; ++i) cofactors.col(i) = H.col((i + 1) % 3).cross(H.col((i + 2) % 3));
  if (cofactors.norm() > kNoDirection * H.squaredNorm()) return fitRotation(H.transpose());
  Index largest = 0;
  if (H.colwise().norm().maxCoeff(&largest) == 0) return Mat3::Identity();
  const Vec3 to = H.col(largest).normalized(), from = (H.transpose() * to).normalized();
  return Eigen::Quaterniond::FromTwoVectors(from, to).toRotationMatrix();
}

Mat3 turnAbout(const Vec3& axis, const std::vector<Vec3>& from, const std::vector<Vec3>& to) {
  double along = 0, across = 0;
  for (std::size_t i = 0; i < from.size(); ++i) {
    along += axis.cross(from[i]).dot(axis.cross(to[i]));
    across += axis.dot(from[i].cross(to[i]));
  }
  return Eigen::AngleAxisd(std::atan2(across, along), axis).toRotationMatrix();
}

}  // namespace

RigidMotion alignment(const std::vector<Vec3>& held, const std::vector<Vec3>& points,
                      const std::vector<Vec3>& targets) {
  RigidMotion motion;
  const HeldPoints hold(held);
  if (points.empty() || hold.rank == HeldPoints::Rank::plane) return motion;
  const bool isLoose = hold.rank == HeldPoints::Rank::none;
  motion.center = isLoose ? meanOf(points) : hold.center;
  const Vec3 goal = isLoose ? meanOf(targets) : hold.center;
  motion.shift = goal - motion.center;
  std::vector<Vec3> from, to;
  Mat3 H = Mat3::Zero();
  for (std::size_t i = 0; i < points.size(); ++i) {
    from.push_back(points[i] - motion.center);
    to.push_back(targets[i] - goal);
    H += to[i] * from[i].transpose();
  }
  motion.turn = hold.rank == HeldPoints::Rank::line ? turnAbout(hold.direction, from, to) : nearestRotation(H);
  return motion;
}

}  // namespace whittle
