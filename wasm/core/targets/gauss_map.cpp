#include "targets/gauss_map.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace whittle {

const Vec3 GaussMap::kTieAxis = Vec3(0.31, 0.52, 0.83).normalized();

namespace {

Points unitRows(const Points& rows) {
  Points result = rows;
  for (Index r = 0; r < rows.rows(); ++r) result.row(r) = rows.row(r).stableNormalized();
  return result;
}

/// The first row that is no direction, or −1.
Index badDirection(const Points& rows) {
  for (Index r = 0; r < rows.rows(); ++r) {
    if (!rows.row(r).allFinite() || rows.row(r).isZero(0)) return r;
  }
  return -1;
}

Status refused(const std::string& what, Element element = {}) {
  return Status::failure(Code::badParameter, "the style's Gauss map " + what, element);
}

/// The turn that decides ties, by 1e-3 radians.
const Mat3 kTieTurn = Eigen::AngleAxisd(1e-3, GaussMap::kTieAxis).toRotationMatrix();

/// So many cells that each holds a few of so many items.
int gridSide(Index items) { return std::clamp(static_cast<int>(std::sqrt(static_cast<double>(items) / 2)), 4, 48); }

}  // namespace

bool operator==(const GaussMapData& a, const GaussMapData& b) {
  const auto same = [](const auto& x, const auto& y) { return x.rows() == y.rows() && x == y; };
  return a.kind == b.kind && same(a.normals, b.normals) && same(a.points, b.points) && same(a.triangles, b.triangles);
}

Status validateGaussMap(const GaussMapData& data) {
  if (data.normals.rows() == 0) return refused("has no normals");
  if (const Index r = badDirection(data.normals); r >= 0)
    return refused("has no direction at normal {}", Element::item(r));
  if (data.kind == GaussMapData::Kind::closest) return {};
  if (const Index r = badDirection(data.points); r >= 0)
    return refused("has no direction at point {}", Element::item(r));
  if (data.triangles.rows() == 0) return refused("has no triangles");
  if (data.triangles.minCoeff() < 0 || data.triangles.maxCoeff() >= data.points.rows()) {
    return refused("has a triangle that uses a point which is not there");
  }
  const bool perVertex = data.kind == GaussMapData::Kind::perVertex;
  if (data.normals.rows() == (perVertex ? data.points.rows() : data.triangles.rows())) return {};
  return refused(perVertex ? "must have a normal for each point" : "must have a normal for each triangle");
}

GaussMap::GaussMap(GaussMapData data)
    : data_(std::move(data)), normals_(unitRows(data_.normals)), points_(unitRows(data_.points)) {
  if (data_.kind == GaussMapData::Kind::closest) {
    collectClosest();
  } else {
    collectTriangles();
  }
}

void GaussMap::collectClosest() {
  const Index count = static_cast<Index>(normals_.rows());
  grid_ = DirectionGrid(gridSide(count));
  std::vector<std::pair<int, Index>> pairs;
  for (int cell = 0; cell < grid_.cellCount(); ++cell) {
    // What is nearest to a place of the cell is at most its diameter further from the middle than the nearest there.
    const Scalars cosines = normals_ * grid_.middle(cell);
    const double reach = std::acos(std::clamp(cosines.maxCoeff(), -1.0, 1.0)) + 2 * grid_.radius(cell) + 1e-6;
    const double least = reach < EIGEN_PI ? std::cos(reach) : -2;
    for (Index i = 0; i < count; ++i) {
      if (cosines[i] >= least) pairs.emplace_back(cell, i);
    }
  }
  grid_.setCandidates(pairs);
}

void GaussMap::collectTriangles() {
  const Index count = static_cast<Index>(data_.triangles.rows());
  grid_ = DirectionGrid(gridSide(count));
  planes_.resize(count);
  std::vector<std::pair<int, Index>> pairs;
  std::vector<int> cells;
  std::vector<bool> filled(grid_.cellCount(), false);
  Points middles(count, 3);
  for (Index f = 0; f < count; ++f) {
    Mat3 corners;
    for (int k = 0; k < 3; ++k) corners.col(k) = points_.row(data_.triangles(f, k)).transpose();
    for (int k = 0; k < 3; ++k)
      planes_[f].row(k) = corners.col((k + 1) % 3).cross(corners.col((k + 2) % 3)).transpose();
    middles.row(f) = corners.rowwise().sum().stableNormalized().transpose();
    // One without area holds no direction of its own.
    if ((corners.col(1) - corners.col(0)).cross(corners.col(2) - corners.col(0)).norm() < 1e-14) continue;
    cells.clear();
    grid_.cellsOf(corners, cells);
    for (const int cell : cells) {
      pairs.emplace_back(cell, f);
      filled[cell] = true;
    }
  }
  for (int cell = 0; cell < grid_.cellCount(); ++cell) {
    if (filled[cell]) continue;
    Index nearest;
    (middles * grid_.middle(cell)).maxCoeff(&nearest);
    pairs.emplace_back(cell, nearest);
  }
  grid_.setCandidates(pairs);
}

Index GaussMap::locate(const Vec3& n, Vec3& weights) const {
  const int cell = grid_.cellOf(n);
  Index best = *grid_.begin(cell);
  double bestCosine = -2;
  weights = Vec3::UnitX();
  for (const Index* f = grid_.begin(cell); f != grid_.end(cell); ++f) {
    const Vec3 w = planes_[*f] * n;
    if (w.minCoeff() >= 0 && w.sum() > 0) {
      weights = w;
      return *f;
    }
    // Not in it: its nearest place, more or less.
    const Vec3 inside = w.cwiseMax(0);
    if (inside.sum() <= 0) continue;
    Vec3 place = Vec3::Zero();
    for (int k = 0; k < 3; ++k) place += inside[k] * points_.row(data_.triangles(*f, k)).transpose();
    const double cosine = place.dot(n) / place.norm();
    if (cosine <= bestCosine) continue;
    best = *f, bestCosine = cosine, weights = inside;
  }
  return best;
}

Index GaussMap::closest(const Vec3& n) const {
  const int cell = grid_.cellOf(n);
  Index best = *grid_.begin(cell);
  double bestCosine = -INFINITY;
  for (const Index* i = grid_.begin(cell); i != grid_.end(cell); ++i) {
    const double cosine = normals_.row(*i) * n;
    if (cosine > bestCosine) best = *i, bestCosine = cosine;
  }
  return best;
}

Vec3 GaussMap::operator()(const Vec3& n) const {
  if (n.isZero(0)) return Vec3::Zero();
  Vec3 weights;
  if (data_.kind == GaussMapData::Kind::closest) return normals_.row(closest(kTieTurn * n)).transpose();
  if (data_.kind == GaussMapData::Kind::perFace) return normals_.row(locate(kTieTurn * n, weights)).transpose();
  const Index f = locate(n, weights);
  Vec3 sum = Vec3::Zero();
  for (int k = 0; k < 3; ++k) sum += weights[k] * normals_.row(data_.triangles(f, k)).transpose();
  // Corners that cancel have no mean: the nearest of them.
  if (sum.norm() > 1e-9 * weights.sum()) return sum.normalized();
  int k;
  weights.maxCoeff(&k);
  return normals_.row(data_.triangles(f, k)).transpose();
}

}  // namespace whittle
