#include "geometry/curvature.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
namespace whittle {

namespace {

constexpr double kQuarterTurn = EIGEN_PI / 2;
constexpr int kRings = 3;
/// Bounds for hubs of hundreds of faces, so that no time is a square: what a vertex takes part of its neighbours, evenly
/// spread, and of all its rings.
constexpr Index kMostNeighbours = 32, kMostInRings = 128;
constexpr Index kVerticesOfSlice = 4000, kFacesOfSlice = 100000;

/// How little coefficients cost, for neighbourhoods of ring radius 1, where samples leave them open: a strip of two rows
/// cannot tell a slope across from a bend, and is taken to slope.
constexpr double kCostOfBend = 1e-6, kCostOfSlope = 1e-9;

/// z = a x² + b xy + c y² + d x + e y.
using Quadric = Eigen::Matrix<double, 5, 1>;

/// The larger eigenvalue of a symmetric 2×2 matrix, the smaller, and the angle of the first one's direction.
struct Eigen2 {
  double larger, smaller, angle;
  Eigen2(double xx, double xy, double yy) {
    const double mean = (xx + yy) / 2, radius = std::hypot((xx - yy) / 2, xy);
    larger = mean + radius, smaller = mean - radius;
    angle = std::atan2(2 * xy, xx - yy) / 2;
  }
};

}  // namespace

CurvatureEstimate::CurvatureEstimate(const Points& positions, const Triangles& triangles, const MeshEdges& edges,
                                     std::vector<bool> features)
    : positions_(positions), triangles_(triangles), edges_(edges), features_(std::move(features)) {}

double CurvatureEstimate::next() {
  if (!cut_) {
    prepare();
  } else if (nextVertex_ < cut_->count()) {
    for (const Index end = std::min(cut_->count(), nextVertex_ + kVerticesOfSlice); nextVertex_ < end; ++nextVertex_) {
      collectRings(nextVertex_);
      principal_[nextVertex_] = fit(nextVertex_);
    }
  } else {
    const Index count = static_cast<Index>(triangles_.rows());
    for (const Index end = std::min(count, nextFace_ + kFacesOfSlice); nextFace_ < end; ++nextFace_) average(nextFace_);
    if (nextFace_ == count) return 1;
  }
  return 0.05 + 0.9 * nextVertex_ / std::max<Index>(cut_->count(), 1) +
         0.04 * nextFace_ / std::max<Index>(static_cast<Index>(triangles_.rows()), 1);
}

void CurvatureEstimate::prepare() {
  cut_.emplace(triangles_, edges_, features_);
  const Index count = cut_->count(), faceCount = static_cast<Index>(triangles_.rows());
  normals_ = Points::Zero(count, 3);
  for (Index f = 0; f < faceCount; ++f) {
    const Vec3 a = positions_.row(triangles_(f, 0)), b = positions_.row(triangles_(f, 1)),
               c = positions_.row(triangles_(f, 2));
    const Eigen::RowVector3d vector = (b - a).cross(c - a).transpose();
    for (int k = 0; k < 3; ++k) normals_.row(cut_->triangles(f, k)) += vector;
  }
  for (Index v = 0; v < count; ++v) {
    const double length = normals_.row(v).norm();
    if (length > 0) normals_.row(v) /= length;
  }
  principal_.resize(count);
  seenFrom_.assign(count, -1);
  ring_.reserve(kMostInRings);
  result_ = {Scalars(faceCount), Scalars(faceCount), Points(faceCount, 3)};
}

void CurvatureEstimate::collectRings(Index vertex) {
  ring_.clear();
  seenFrom_[vertex] = vertex;
  const auto addNeighbours = [&](Index v) {
    const Index first = cut_->start[v], last = cut_->start[v + 1];
    const Index stride = (last - first + kMostNeighbours - 1) / kMostNeighbours;
    for (Index i = first; i < last && static_cast<Index>(ring_.size()) < kMostInRings; i += stride) {
      const Index neighbour = cut_->neighbours[i];
      if (seenFrom_[neighbour] == vertex) continue;
      seenFrom_[neighbour] = vertex;
      ring_.push_back(neighbour);
    }
  };
  addNeighbours(vertex);
  std::size_t first = 0;
  for (int ring = 1; ring < kRings; ++ring) {
    const std::size_t last = ring_.size();
    for (; first < last; ++first) addNeighbours(ring_[first]);
  }
}

CurvatureEstimate::Principal CurvatureEstimate::fit(Index vertex) const {
  const Vec3 normal = normals_.row(vertex), origin = at(vertex);
  double radius = 0;
  for (const Index v : ring_) radius = std::max(radius, (at(v) - origin).squaredNorm());
  radius = std::sqrt(radius);
  if (normal.isZero(0) || !(radius > 0)) return {};

  const Vec3 u = normal.unitOrthogonal(), v = normal.cross(u);
  Eigen::Matrix<double, 5, 5> matrix = Eigen::Matrix<double, 5, 5>::Zero();
  Quadric rhs = Quadric::Zero();
  for (const Index sample : ring_) {
    // What has turned away is no graph over the tangent plane, and the less it has the better a quadric fits. On spheres
    // and cylinders heights are ½ k x² · 2 / (1 + cosine), so that with the factor below a quadric fits exactly, however
    // coarse they are; elsewhere it vanishes with the size of the rings.
    const double cosine = normals_.row(sample).dot(normal.transpose());
    if (!(cosine > 0)) continue;
    const double weight = cosine * cosine;
    const Vec3 offset = (at(sample) - origin) / radius;
    const double x = offset.dot(u), y = offset.dot(v);
    Quadric row;
    row << x * x, x * y, y * y, x, y;
    matrix.noalias() += (weight * row) * row.transpose();
    rhs += (weight * (1 + cosine) / 2 * offset.dot(normal)) * row;
  }
  Quadric cost;
  cost << kCostOfBend, kCostOfBend / 2, kCostOfBend, kCostOfSlope, kCostOfSlope;
  matrix.diagonal() += cost;
  const Quadric q = matrix.ldlt().solve(rhs);

  // The second fundamental form in an orthonormal frame of the tangent plane: X over u, Y at right angles to it.
  const double d = q[3], e = q[4], E = 1 + d * d, area = std::sqrt(1 + d * d + e * e);
  const Eigen::Vector2d X(1 / std::sqrt(E), 0), Y(-d * e / (std::sqrt(E) * area), std::sqrt(E) / area);
  Eigen::Matrix2d form;
  form << 2 * q[0], q[1], q[1], 2 * q[2];
  form /= -area * radius;
  const Eigen2 principal(X.dot(form * X), X.dot(form * Y), Y.dot(form * Y));
  const Eigen::Vector2d along = std::cos(principal.angle) * X + std::sin(principal.angle) * Y;
  return {principal.larger, principal.smaller, along[0] * u + along[1] * v + (d * along[0] + e * along[1]) * normal};
}

void CurvatureEstimate::average(Index face) {
  const Vec3 a = positions_.row(triangles_(face, 0)), b = positions_.row(triangles_(face, 1)),
             c = positions_.row(triangles_(face, 2));
  const Vec3 normal = (b - a).cross(c - a).stableNormalized();
  const Principal* corners[3];
  for (int k = 0; k < 3; ++k) corners[k] = &principal_[cut_->triangles(face, k)];
  const double larger = (corners[0]->larger + corners[1]->larger + corners[2]->larger) / 3;
  const double smaller = (corners[0]->smaller + corners[1]->smaller + corners[2]->smaller) / 3;
  result_.larger[face] = larger;
  result_.smaller[face] = smaller;
  result_.direction.row(face).setZero();
  if (normal.isZero(0)) return;

  const Vec3 u = normal.unitOrthogonal(), v = normal.cross(u);
  double cosine = 0, sine = 0;  // of twice the angle: directions have no sign
  for (const Principal* corner : corners) {
    const double x = corner->direction.dot(u), y = corner->direction.dot(v);
    const double weight = (corner->larger - corner->smaller) / std::max(x * x + y * y, 1e-30);
    cosine += weight * (x * x - y * y);
    sine += weight * 2 * x * y;
  }
  if (cosine == 0 && sine == 0) return;
  const double angle = std::atan2(sine, cosine) / 2 + (std::abs(larger) < std::abs(smaller) ? kQuarterTurn : 0);
  result_.direction.row(face) = (std::cos(angle) * u + std::sin(angle) * v).transpose();
}

}  // namespace whittle
