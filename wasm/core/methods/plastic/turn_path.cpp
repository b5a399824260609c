#include "methods/plastic/turn_path.h"

#include <algorithm>
#include <cmath>

#include "methods/plastic/alignment.h"
#include "methods/plastic/held_points.h"

namespace whittle {

namespace {

constexpr double kDegree = 3.14159265358979323846 / 180;
/// A turn that is farther goes along its way, so far at a time.
constexpr double kFar = 75 * kDegree, kLeg = 60 * kDegree;
/// What may be beside the turn, as a share of how far the landmarks are spread.
constexpr double kBeside = 0.5;

/// The angle that comes to the same place and whose size is nearest to a given one.
double wholeAngle(double angle, double size) {
  constexpr double kRound = 360 * kDegree;
  if (size == 0) return angle;
  const double forward = angle + kRound * std::max(0.0, std::round((size - angle) / kRound));
  const double back = angle - kRound * std::max(1.0, std::round((size + angle) / kRound));
  return std::abs(forward - size) <= std::abs(-back - size) ? forward : back;
}

}  // namespace

TurnPath::TurnPath(const std::vector<Vec3>& points, const std::vector<Vec3>& targets, double turn)
    : points_(points), targets_(targets) {
  if (points.size() < 3 || HeldPoints(points).rank != HeldPoints::Rank::plane) return;
  const RigidMotion motion = alignment({}, points, targets);
  double spread = 0, rest = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    beside_.push_back(targets[i] - motion(points[i]));
    spread += (points[i] - motion.center).squaredNorm();
    rest += beside_[i].squaredNorm();
  }
  if (rest > kBeside * kBeside * spread) return;
  const Eigen::AngleAxisd screw(motion.turn);
  axis_ = screw.axis();
  angle_ = wholeAngle(screw.angle(), turn);
  if (std::abs(angle_) <= kFar) return;
  pitch_ = motion.shift.dot(axis_);
  const Vec3 across = motion.shift - pitch_ * axis_;
  center_ = motion.center + (across + axis_.cross(across) / std::tan(screw.angle() / 2)) / 2;
  legs_ = static_cast<int>(std::ceil(std::abs(angle_) / kLeg));
}

Vec3 TurnPath::target(std::size_t landmark, int leg) const {
  if (leg >= legs_) return targets_[landmark];
  const double share = static_cast<double>(leg) / legs_;
  const Mat3 turn = Eigen::AngleAxisd(share * angle_, axis_).toRotationMatrix();
  return center_ + turn * (points_[landmark] - center_) + share * (pitch_ * axis_ + beside_[landmark]);
}

}  // namespace whittle
