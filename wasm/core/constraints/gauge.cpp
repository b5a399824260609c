#include "constraints/gauge.h"

namespace whittle {

Gauge::Gauge(const Components& components, const std::vector<Index>& handles, const Points& rest,
             const Scalars& areas) {
  constexpr Index kHeld = -1;
  constexpr Index kUnseen = -2;
  std::vector<Index> floatingOf(components.count, kUnseen);
  for (const Index v : handles) floatingOf[components.ofVertex[v]] = kHeld;

  const Index vertexCount = static_cast<Index>(rest.rows());
  floatingPart_.assign(4 * batchCount(vertexCount), kHeld);
  for (Index v = 0; v < vertexCount; ++v) {
    Index& part = floatingOf[components.ofVertex[v]];
    if (part == kUnseen) {
      part = static_cast<Index>(pins_.size());
      pins_.push_back(v);
    }
    floatingPart_[v] = part;
  }

  // A part without area (one vertex, or degenerate faces only) is weighted by vertex.
  Scalars partArea = Scalars::Zero(pins_.size());
  Scalars partSize = Scalars::Zero(pins_.size());
  for (Index v = 0; v < vertexCount; ++v) {
    if (floatingPart_[v] == kHeld) continue;
    partArea[floatingPart_[v]] += areas[v];
    partSize[floatingPart_[v]] += 1;
  }
  weights_ = Scalars::Zero(vertexCount);
  for (Index v = 0; v < vertexCount; ++v) {
    const Index part = floatingPart_[v];
    if (part != kHeld) weights_[v] = partArea[part] > 0 ? areas[v] / partArea[part] : 1 / partSize[part];
  }

  restCentroids_.resize(pins_.size(), 3);
  shifts_.resize(pins_.size(), 3);
  laneShifts_.assign(pins_.size() + 1, {});
  sumCentroids(rest, restCentroids_);
}

void Gauge::sumCentroids(const Points& positions, Points& centroids) const {
  centroids.setZero();
  for (Index v = 0; v < positions.rows(); ++v) {
    if (floatingPart_[v] >= 0) centroids.row(floatingPart_[v]) += weights_[v] * positions.row(v);
  }
}

void Gauge::restoreCentroids(Points& positions) {
  sumCentroids(positions, shifts_);
  shifts_ = restCentroids_ - shifts_;
  for (Index v = 0; v < positions.rows(); ++v) {
    if (floatingPart_[v] >= 0) positions.row(v) += shifts_.row(floatingPart_[v]);
  }
}

void Gauge::balance(const LaneRows& displacements, const LaneRows& moves) {
  if (pins_.empty()) return;
  shifts_.setZero();
  for (Index v = 0; v < weights_.size();) {
    // Vertices of one part mostly follow each other: their sum stays at hand.
    const Index part = floatingPart_[v];
    DoubleLanes sum{};
    for (; v < weights_.size() && floatingPart_[v] == part; ++v) {
      sum += weights_[v] * toDouble(load(&displacements[v]) + load(&moves[v]));
    }
    if (part >= 0) shifts_.row(part) -= Eigen::RowVector3d(sum[0], sum[1], sum[2]);
  }
  for (Index part = 0; part < shifts_.rows(); ++part) {
    const auto shift = shifts_.row(part).cast<float>();
    laneShifts_[part + 1] = {shift[0], shift[1], shift[2], 0};
  }
}

}  // namespace whittle
