#include "methods/alternating/vertex_system.h"

#include <Eigen/LU>
#include <algorithm>

namespace whittle {

namespace {

constexpr int kMostIterations = 300;

/// The pairs of vertices that an edge or a row of constants has together, the smaller first, rising.
std::vector<std::array<Index, 2>> coupledPairs(const RestSurface& surface, const std::vector<PointRow>& rows) {
  std::vector<std::array<Index, 2>> pairs = surface.edges.ends;
  for (const PointRow& row : rows) {
    for (int i = 0; i < row.count; ++i) {
      for (int j = 0; j < i; ++j) {
        const auto [low, high] = std::minmax(row.vertices[i], row.vertices[j]);
        if (low != high) pairs.push_back({low, high});
      }
    }
  }
  if (pairs.size() == surface.edges.ends.size()) return pairs;
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  return pairs;
}

}  // namespace

void VertexSystem::shape(const RestSurface& surface, const EnergyWeights& weights, std::vector<PointRow> rows) {
  surface_ = &surface;
  weights_ = weights;
  rows_ = std::move(rows);
  system_.shape(surface.vertexCount(), coupledPairs(surface, rows_));
  pairOf_.clear();
  for (const auto& [low, high] : surface.edges.ends) pairOf_.push_back(system_.findPair(low, high));
  diagonal_.assign(surface.vertexCount(), Mat3::Zero());
  couplings_.assign(system_.pairCount(), Mat3::Zero());
  for (Index f = 0; f < surface.faceCount(); ++f) {
    if (surface.sphericity[f] > 0) addSphericity(f);
  }
  for (const PointRow& row : rows_) {
    if (!row.isOfLine()) addRow(row, diagonal_, couplings_);
  }
  rhs_.resize(surface.vertexCount(), 3);
}

void VertexSystem::add(Index v, Index w, const Mat3& block, std::vector<Mat3>& diagonal,
                       std::vector<Mat3>& couplings) const {
  if (v == w) {
    diagonal[v] += block + block.transpose();
  } else if (v > w) {
    couplings[system_.findPair(w, v)] += block;
  } else {
    couplings[system_.findPair(v, w)] += block.transpose();
  }
}

void VertexSystem::addSphericity(Index face) {
  const Triangles& triangles = surface_->mesh.triangles;
  for (int i = 0; i < 3; ++i) {
    Mat3 factors[3];
    sphericityFactors(*surface_, face, i, factors);
    for (int a = 0; a < 3; ++a) {
      const Mat3 weighted = surface_->sphericity[face] * factors[a].transpose();
      diagonal_[triangles(face, a)] += weighted * factors[a];
      for (int b = 0; b < a; ++b)
        add(triangles(face, a), triangles(face, b), weighted * factors[b], diagonal_, couplings_);
    }
  }
}

void VertexSystem::addRow(const PointRow& row, std::vector<Mat3>& diagonal, std::vector<Mat3>& couplings) const {
  const Mat3 metric = row.stiffness * row.metric();
  for (int i = 0; i < row.count; ++i) {
    diagonal[row.vertices[i]] += row.coefficients[i] * row.coefficients[i] * metric;
    for (int j = 0; j < i; ++j) {
      add(row.vertices[i], row.vertices[j], row.coefficients[i] * row.coefficients[j] * metric, diagonal, couplings);
    }
  }
}

/// Lines get the present lengths of their edges.
void VertexSystem::addLines(const EdgeGoals& goals) {
  for (PointRow& row : rows_) {
    if (!row.isOfLine()) continue;
    row.setLineLengths(goals.targetLengths[row.halfEdges[0]], goals.targetLengths[row.halfEdges[1]]);
    addRow(row, system_.diagonal(), system_.couplings());
  }
}

void VertexSystem::restart() {
  std::copy(diagonal_.begin(), diagonal_.end(), system_.diagonal().begin());
  std::copy(couplings_.begin(), couplings_.end(), system_.couplings().begin());
  rhs_.setZero();
}

void VertexSystem::addEdge(Index edge, const Mat3& K) {
  const auto [low, high] = surface_->edges.ends[edge];
  system_.diagonal()[low] += K;
  system_.diagonal()[high] += K;
  system_.couplings()[pairOf_[edge]] -= K;
}

void VertexSystem::assemble(const EdgeGoals& goals, const Transformations& transformations) {
  const RestSurface& surface = *surface_;
  restart();
  addLines(goals);
  for (Index e = 0; e < surface.edges.count(); ++e) {
    const Index first = surface.edges.halfEdges[surface.edges.start[e]];
    const double scale = weights_.scale / surface.averageLength;
    Mat3 K = scale * Mat3::Identity();
    const auto [low, high] = surface.edges.ends[e];
    // Half edges run from the low vertex to the high one or back.
    const auto isUpward = [&, low = low](Index h) { return surface.mesh.triangles(faceOf(h), tailCorner(h)) == low; };
    Vec3 g = (isUpward(first) ? scale : -scale) * goals.vectors.row(first).transpose();
    for (Index place = surface.edges.start[e]; place < surface.edges.start[e + 1]; ++place) {
      const Index h = surface.edges.halfEdges[place];
      const Mat3 inverse = transformations[faceOf(h)].inverse();
      const double rest = goals.lengths[h], transform = goals.stress[h] / (rest * rest);
      const double normal = weights_.normal * goals.stress[h] * (rest / surface.averageLength) /
                            (goals.targetLengths[h] * goals.targetLengths[h]);
      const Vec3 n = goals.normals.row(h).transpose();
      K += transform * inverse.transpose() * inverse + normal * n * n.transpose();
      g += (isUpward(h) ? transform : -transform) * inverse.transpose() * goals.vectors.row(h).transpose();
    }
    addEdge(e, K);
    rhs_.row(low) -= g.transpose();
    rhs_.row(high) += g.transpose();
  }
  addTargets();
}

void VertexSystem::assemblePoisson() {
  const RestSurface& surface = *surface_;
  restart();
  for (Index e = 0; e < surface.edges.count(); ++e) {
    const Mat3 K = surface.edges.faceCountAt(e) / surface.averageLength * Mat3::Identity();
    addEdge(e, K);
    const auto [low, high] = surface.edges.ends[e];
    const Eigen::RowVector3d g = K(0, 0) * (surface.mesh.positions.row(high) - surface.mesh.positions.row(low));
    rhs_.row(low) -= g;
    rhs_.row(high) += g;
  }
  addTargets();
}

void VertexSystem::addTargets() {
  for (const PointRow& row : rows_) {
    const Eigen::RowVector3d pull = (row.stiffness * row.metric() * row.target).transpose();
    for (int i = 0; i < row.count; ++i) rhs_.row(row.vertices[i]) += row.coefficients[i] * pull;
  }
}

void VertexSystem::beginSolve(double tolerance, Points& positions) {
  system_.beginImprove(rhs_, tolerance, kMostIterations, positions);
}

Status VertexSystem::solve(double tolerance, Points& positions) {
  beginSolve(tolerance, positions);
  Status status;
  for (bool isDone = false; !isDone && status.ok();) status = solveNext(isDone);
  return status;
}

}  // namespace whittle
