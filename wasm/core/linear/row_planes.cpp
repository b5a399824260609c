#include "linear/row_planes.h"

#include <algorithm>
#include <cmath>

namespace whittle {

namespace {

constexpr double kSameOffset = 1e-9;
/// What rounding leaves between a point and a plane that it is on.
constexpr double kOnPlane = 1e-14;

Status refusal(Index row, const char* why) { return Status::failure(Code::badPlanes, why, Element::item(row)); }

/// The direction across q that is nearest to the axis of space farthest from it; an axis if q is one.
Vec3 across(const Vec3& q) {
  int farthest;
  q.cwiseAbs().minCoeff(&farthest);
  Vec3 direction = Vec3::Unit(farthest) - q[farthest] * q;
  direction -= q.dot(direction) * q;
  return direction.normalized();
}

/// Adds a plane to those of a row, whose held axes are the last ones.
Status add(const RowPlane& plane, double sameNormal, HeldRow& row) {
  const double length = plane.normal.stableNorm();
  if (!(length > 0) || !std::isfinite(length) || !std::isfinite(plane.offset)) {
    return refusal(plane.row, "the plane has no direction or place; give it a normal and an offset that are numbers");
  }
  Vec3 rest = plane.normal / length;
  double offset = plane.offset / length;
  for (int pass = 0; pass < 2; ++pass) {  // the second takes off what rounding has left
    for (int k = row.freedom; k < 3; ++k) {
      const double along = rest.dot(row.axes[k]);
      rest -= along * row.axes[k];
      offset -= along * row.held[k];
    }
  }
  const double sine = rest.norm();
  if (row.freedom == 0 || sine < sameNormal) {
    if (std::abs(offset) <= kSameOffset) return {};
    return refusal(plane.row, "the vertex is held on planes that do not meet in a point; hold it on fewer of them");
  }
  --row.freedom;
  row.axes[row.freedom] = rest / sine;
  row.held[row.freedom] = offset / sine;
  return {};
}

/// The axes that are free.
void complete(HeldRow& row) {
  if (row.freedom == 1) row.axes[0] = row.axes[1].cross(row.axes[2]).normalized();
  if (row.freedom == 2) {
    row.axes[0] = across(row.axes[2]);
    row.axes[1] = row.axes[2].cross(row.axes[0]).normalized();
  }
}

}  // namespace

void HeldRow::satisfy(Eigen::Ref<Vec3> x) const {
  for (int k = freedom; k < 3; ++k) {
    const double away = held[k] - axes[k].dot(x);
    if (std::abs(away) > kOnPlane) x += away * axes[k];
  }
}

void satisfyPlanes(const std::vector<HeldRow>& rows, Points& X) {
  for (const HeldRow& each : rows) {
    Vec3 x = X.row(each.row).transpose();
    each.satisfy(x);
    X.row(each.row) = x.transpose();
  }
}

Status joinPlanes(std::vector<RowPlane> planes, std::vector<HeldRow>& rows, double sameNormal) {
  rows.clear();
  std::stable_sort(planes.begin(), planes.end(), [](const RowPlane& a, const RowPlane& b) { return a.row < b.row; });
  for (const RowPlane& plane : planes) {
    if (rows.empty() || rows.back().row != plane.row) rows.push_back({plane.row, 3, {}, {}});
    if (Status status = add(plane, sameNormal, rows.back()); !status.ok()) return status;
  }
  for (HeldRow& row : rows) complete(row);
  return {};
}

}  // namespace whittle
