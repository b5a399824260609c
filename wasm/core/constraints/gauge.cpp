#include "constraints/gauge.h"

namespace whittle {

namespace {

/// Sine below which planes do not hold a part across the first of them: what single precision would make of so little.
constexpr double kParallel = 0.02;

/// Directions in which the planes leave each part loose (rows are parts).
std::vector<HeldRow> partsOnPlanes(const Components& components, const Planes& planes) {
  std::vector<RowPlane> ofParts;
  for (const Plane& plane : planes) {
    const std::size_t first = ofParts.size();
    for (const Index v : plane.vertices) {
      const Index part = components.ofVertex[v];
      if (ofParts.size() > first && ofParts.back().row == part) continue;
      ofParts.push_back({part, plane.normal, 0});
    }
  }
  std::vector<HeldRow> parts;
  (void)joinPlanes(std::move(ofParts), parts, kParallel);  // through one point they do not exclude each other
  return parts;
}

}  // namespace

Gauge::Gauge(const Components& components, const std::vector<Index>& handles, const Points& rest, const Scalars& areas,
             const Planes& planes) {
  constexpr Index kHeld = -1;
  constexpr Index kUnseen = -2;
  const std::vector<HeldRow> onPlanes = partsOnPlanes(components, planes);
  std::vector<Index> looseOf(components.count, kUnseen);
  for (const Index v : handles) looseOf[components.ofVertex[v]] = kHeld;
  for (const HeldRow& part : onPlanes) {
    if (part.freedom == 0) looseOf[part.row] = kHeld;
  }

  const Index vertexCount = static_cast<Index>(rest.rows());
  std::vector<Index> firstOf;  // vertex of each loose part
  loosePart_.assign(4 * batchCount(vertexCount), kHeld);
  for (Index v = 0; v < vertexCount; ++v) {
    Index& part = looseOf[components.ofVertex[v]];
    if (part == kUnseen) {
      part = static_cast<Index>(firstOf.size());
      firstOf.push_back(v);
    }
    loosePart_[v] = part;
  }

  std::vector<bool> slides(firstOf.size(), false);
  for (const HeldRow& each : onPlanes) {
    const Index part = looseOf[each.row];
    if (part == kHeld) continue;
    slides[part] = true;
    slides_.push_back({part, Mat3::Zero()});
    for (int k = 0; k < each.freedom; ++k) {
      slides_.back().along += each.axes[k] * each.axes[k].transpose();
      pinPlanes_.push_back({firstOf[part], each.axes[k], 0});
    }
  }
  for (std::size_t part = 0; part < firstOf.size(); ++part) {
    if (!slides[part]) pins_.push_back(firstOf[part]);
  }
  restCentroids_.resize(firstOf.size(), 3);
  shifts_.resize(firstOf.size(), 3);
  laneShifts_.assign(firstOf.size() + 1, {});
  weighCentroids(rest, areas);
}

void Gauge::weighCentroids(const Points& rest, const Scalars& areas) {
  // A part without area (one vertex, or degenerate faces only) is weighted by vertex.
  Scalars partArea = Scalars::Zero(shifts_.rows());
  Scalars partSize = Scalars::Zero(shifts_.rows());
  for (Index v = 0; v < rest.rows(); ++v) {
    if (loosePart_[v] < 0) continue;
    partArea[loosePart_[v]] += areas[v];
    partSize[loosePart_[v]] += 1;
  }
  weights_ = Scalars::Zero(rest.rows());
  for (Index v = 0; v < rest.rows(); ++v) {
    const Index part = loosePart_[v];
    if (part >= 0) weights_[v] = partArea[part] > 0 ? areas[v] / partArea[part] : 1 / partSize[part];
  }
  sumCentroids(rest, restCentroids_);
}

void Gauge::sumCentroids(const Points& positions, Points& centroids) const {
  centroids.setZero();
  for (Index v = 0; v < positions.rows(); ++v) {
    if (loosePart_[v] >= 0) centroids.row(loosePart_[v]) += weights_[v] * positions.row(v);
  }
}

void Gauge::keepOnPlanes(Points& shifts) const {
  for (const auto& [part, along] : slides_) {
    const Vec3 shift = along * shifts.row(part).transpose();
    shifts.row(part) = shift.transpose();
  }
}

void Gauge::restoreCentroids(Points& positions) {
  sumCentroids(positions, shifts_);
  shifts_ = restCentroids_ - shifts_;
  keepOnPlanes(shifts_);
  for (Index v = 0; v < positions.rows(); ++v) {
    if (loosePart_[v] >= 0) positions.row(v) += shifts_.row(loosePart_[v]);
  }
}

void Gauge::balance(const LaneRows& displacements, const LaneRows& moves) {
  if (shifts_.rows() == 0) return;
  shifts_.setZero();
  for (Index v = 0; v < weights_.size();) {
    // Vertices of one part mostly follow each other: their sum stays at hand.
    const Index part = loosePart_[v];
    DoubleLanes sum{};
    for (; v < weights_.size() && loosePart_[v] == part; ++v) {
      sum += weights_[v] * toDouble(load(&displacements[v]) + load(&moves[v]));
    }
    if (part >= 0) shifts_.row(part) -= Eigen::RowVector3d(sum[0], sum[1], sum[2]);
  }
  keepOnPlanes(shifts_);
  for (Index part = 0; part < shifts_.rows(); ++part) {
    const auto shift = shifts_.row(part).cast<float>();
    laneShifts_[part + 1] = {shift[0], shift[1], shift[2], 0};
  }
}

}  // namespace whittle
