#include "reference/plain_local_global.h"

#include <algorithm>

#include "geometry/cotangent.h"
#include "geometry/surface.h"
#include "mesh/unit_frame.h"
#include "targets/gauss_map.h"

namespace whittle {

void PlainLocalGlobal::assemble() {
  areas_ = barycentricAreas(rest_.positions, rest_.triangles);
  fans_ = smoothFans(rest_.positions, rest_.triangles);
  fanAreas_ = barycentricAreas(rest_.positions, rest_.triangles, fans_);
  normals_ = fanNormals(rest_.positions, rest_.triangles, fans_);
  listHalfEdges();
  if (problem_.strength > 0) lookUpTargets();
  assembleSystem();
  splitSystem();
}

void PlainLocalGlobal::analyze() { cholesky_.analyzePattern(freeBlock_); }

bool PlainLocalGlobal::factorize() {
  cholesky_.factorize(freeBlock_);
  return cholesky_.info() == Eigen::Success;
}

bool PlainLocalGlobal::prepare() {
  assemble();
  analyze();
  return factorize();
}

void PlainLocalGlobal::listHalfEdges() {
  const CornerScalars c = halfCotangents(rest_.positions, rest_.triangles);
  std::vector<std::vector<HalfEdge>> ofVertex(rest_.vertexCount());
  for (Index f = 0; f < rest_.faceCount(); ++f) {
    for (int k = 0; k < 3; ++k) {
      const Index from = rest_.triangles(f, (k + 1) % 3), to = rest_.triangles(f, (k + 2) % 3);
      const Vec3 d = (rest_.positions.row(to) - rest_.positions.row(from)).transpose();
      for (int corner = 0; corner < 3; ++corner) ofVertex[rest_.triangles(f, corner)].push_back({from, to, c(f, k), d});
    }
  }
  start_.assign(1, 0);
  halfEdges_.clear();
  halfEdges_.reserve(9 * rest_.faceCount());
  for (const auto& edges : ofVertex) {
    halfEdges_.insert(halfEdges_.end(), edges.begin(), edges.end());
    start_.push_back(static_cast<Index>(halfEdges_.size()));
  }
}

void PlainLocalGlobal::lookUpTargets() {
  targetWeights_ = problem_.strength * mixedVoronoiAreas(rest_.positions, rest_.triangles, fans_);
  targets_.resize(fans_.count(), 3);
  const GaussMap style({.normals = problem_.style});
  for (Index k = 0; k < fans_.count(); ++k) {
    targets_.row(k) = style(normals_.row(k).transpose()).transpose();
    if (normals_.row(k).isZero(0)) targetWeights_[k] = 0;
  }
}

/// Setting the energy's gradient to zero: Σ_i Σ_e c_e (u_e − R_i d_e) times ±1 at the ends of e.
void PlainLocalGlobal::assembleSystem() {
  const Index n = rest_.vertexCount();
  std::vector<Eigen::Triplet<double, Index>> left, right;
  left.reserve(4 * halfEdges_.size());
  right.reserve(6 * halfEdges_.size());
  for (Index i = 0; i < n; ++i) {
    for (Index e = start_[i]; e < start_[i + 1]; ++e) {
      const auto& [from, to, c, d] = halfEdges_[e];
      left.emplace_back(from, from, c);
      left.emplace_back(to, to, c);
      left.emplace_back(from, to, -c);
      left.emplace_back(to, from, -c);
      for (Index axis = 0; axis < 3; ++axis) {
        right.emplace_back(to, 3 * i + axis, c * d[axis]);
        right.emplace_back(from, 3 * i + axis, -c * d[axis]);
      }
    }
  }
  system_.resize(n, n);
  system_.setFromTriplets(left.begin(), left.end());
  rightHandSideOf_.resize(n, 3 * n);
  rightHandSideOf_.setFromTriplets(right.begin(), right.end());
}

/// Eliminates the handles and one pin for every part that has none.
void PlainLocalGlobal::splitSystem() {
  const Index n = rest_.vertexCount();
  gauge_.emplace(connectedComponents(rest_.triangles, n), problem_.handles.vertices, rest_.positions, areas_);
  held_ = problem_.handles.vertices;
  held_.insert(held_.end(), gauge_->pins().begin(), gauge_->pins().end());
  std::vector<Index> heldIndex(n, -1), freeIndex(n, -1);
  for (std::size_t h = 0; h < held_.size(); ++h) heldIndex[held_[h]] = static_cast<Index>(h);
  free_.clear();
  for (Index v = 0; v < n; ++v) {
    if (heldIndex[v] >= 0) continue;
    freeIndex[v] = static_cast<Index>(free_.size());
    free_.push_back(v);
  }
  std::vector<Eigen::Triplet<double, Index>> ofFree, ofHeld;
  for (Index column = 0; column < n; ++column) {
    for (SparseMatrix::InnerIterator entry(system_, column); entry; ++entry) {
      const Index row = freeIndex[entry.row()];
      if (row < 0) continue;
      if (heldIndex[column] >= 0) {
        ofHeld.emplace_back(row, heldIndex[column], entry.value());
      } else {
        ofFree.emplace_back(row, freeIndex[column], entry.value());
      }
    }
  }
  freeBlock_.resize(free_.size(), free_.size());
  freeBlock_.setFromTriplets(ofFree.begin(), ofFree.end());
  heldBlock_.resize(free_.size(), held_.size());
  heldBlock_.setFromTriplets(ofHeld.begin(), ofHeld.end());
}

void PlainLocalGlobal::begin(Points& positions) {
  applyHandles(problem_.handles, positions);
  admm_.assign(fans_.count(), {});
  rotations_.resize(3 * rest_.vertexCount(), 3);
}

void PlainLocalGlobal::localStep(const Points& positions) {
  for (Index i = 0; i < rest_.vertexCount(); ++i) {
    Mat3 M = Mat3::Zero();
    for (Index e = start_[i]; e < start_[i + 1]; ++e) {
      const HalfEdge& edge = halfEdges_[e];
      M += 2 * edge.c * edge.d * (positions.row(edge.to) - positions.row(edge.from));
    }
    const Index first = fans_.start[i], count = fans_.countAt(i);
    std::vector<PlainNormal> normals;
    bool isCubic = false;
    for (Index k = first; k < first + count; ++k) {
      normals.push_back({normals_.row(k).transpose(), problem_.cubeness * fanAreas_[k]});
      isCubic = isCubic || normals.back().weight > 0;
      if (targetWeights_.size() > 0) M += 2 * targetWeights_[k] * normals_.row(k).transpose() * targets_.row(k);
    }
    const std::span<AdmmState> states{&admm_[first], static_cast<std::size_t>(count)};
    const Mat3 R = isCubic ? plainCubic(M, std::move(normals), problem_.admm, states) : plainRotation(M);
    rotations_.middleRows<3>(3 * i) = R.transpose();
  }
}

void PlainLocalGlobal::rightHandSide() { rightHandSide_ = rightHandSideOf_ * rotations_; }

void PlainLocalGlobal::solve(Points& positions) {
  if (free_.empty()) return;
  Eigen::MatrixXd held(held_.size(), 3), rhs(free_.size(), 3);
  for (std::size_t h = 0; h < held_.size(); ++h) held.row(h) = positions.row(held_[h]);
  for (std::size_t v = 0; v < free_.size(); ++v) rhs.row(v) = rightHandSide_.row(free_[v]);
  const Eigen::MatrixXd solution = cholesky_.solve(rhs - heldBlock_ * held);
  for (std::size_t v = 0; v < free_.size(); ++v) positions.row(free_[v]) = solution.row(v);
  gauge_->restoreCentroids(positions);
}

void PlainLocalGlobal::iterate(Points& positions) {
  localStep(positions);
  rightHandSide();
  solve(positions);
}

double PlainLocalGlobal::energy(const Points& positions) const {
  double sum = 0;
  for (Index i = 0; i < rest_.vertexCount(); ++i) {
    const Mat3 R = rotations_.middleRows<3>(3 * i).transpose();
    for (Index e = start_[i]; e < start_[i + 1]; ++e) {
      const HalfEdge& edge = halfEdges_[e];
      const Vec3 u = (positions.row(edge.to) - positions.row(edge.from)).transpose();
      sum += edge.c * (R * edge.d - u).squaredNorm();
    }
    for (Index k = fans_.start[i]; k < fans_.start[i + 1]; ++k) {
      const Vec3 n = R * normals_.row(k).transpose();
      sum += problem_.cubeness * fanAreas_[k] * n.lpNorm<1>();
      if (targetWeights_.size() > 0) sum += targetWeights_[k] * (n - targets_.row(k).transpose()).squaredNorm();
    }
  }
  return sum;
}

double relativeDisplacement(const Points& before, const Points& after, const Points& rest) {
  const double move = (after - before).rowwise().norm().maxCoeff();
  return move == 0 ? 0 : move / (after - rest).rowwise().norm().maxCoeff();
}

TriangleMesh inUnitFrame(TriangleMesh mesh) {
  const UnitFrame frame = UnitFrame::of(mesh);
  for (Index v = 0; v < mesh.vertexCount(); ++v) {
    mesh.positions.row(v) = frame.toUnit(mesh.positions.row(v).transpose()).transpose();
  }
  return mesh;
}

}  // namespace whittle
