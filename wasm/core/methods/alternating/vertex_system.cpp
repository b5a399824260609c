#include "methods/alternating/vertex_system.h"

#include <Eigen/Geometry>
#include <Eigen/LU>

namespace whittle {

namespace {

/// Beyond so many iterations a new factorization is cheaper than what the old one has left to do.
constexpr int kMostIterations = 12;

}  // namespace

void VertexSystem::shape(const RestSurface& surface, const EnergyWeights& weights, std::vector<PointRow> rows) {
  surface_ = &surface;
  weights_ = weights;
  rows_ = std::move(rows);
  blocks_ = VertexBlocks(surface, rows_);
  matrix_ = blocks_.zero();
  constants_.assign(matrix_.nonZeros(), 0);
  for (Index f = 0; f < surface.faceCount(); ++f) {
    if (surface.sphericity[f] > 0) addSphericity(f);
  }
  addRows();
  rhs_.resize(surface.vertexCount(), 3);
  residual_.resize(3 * surface.vertexCount());
  correction_.resize(3 * surface.vertexCount());
}

void VertexSystem::addSphericity(Index face) {
  const Triangles& triangles = surface_->mesh.triangles;
  for (int i = 0; i < 3; ++i) {
    Mat3 factors[3];
    sphericityFactors(*surface_, face, i, factors);
    for (int a = 0; a < 3; ++a) {
      for (int b = 0; b < a; ++b) {
        blocks_.add(triangles(face, a), triangles(face, b),
                    surface_->sphericity[face] * factors[a].transpose() * factors[b], constants_.data());
      }
      blocks_.addDiagonal(triangles(face, a), surface_->sphericity[face] * factors[a].transpose() * factors[a],
                          constants_.data());
    }
  }
}

void VertexSystem::addRows() {
  for (const PointRow& row : rows_) {
    for (int i = 0; i < row.count; ++i) {
      const auto product = [&](int j) -> Mat3 {
        return row.stiffness * row.coefficients[i] * row.coefficients[j] * Mat3::Identity();
      };
      blocks_.addDiagonal(row.vertices[i], product(i), constants_.data());
      for (int j = 0; j < i; ++j) blocks_.add(row.vertices[i], row.vertices[j], product(j), constants_.data());
    }
  }
}

void VertexSystem::assemble(const EdgeGoals& goals, const Transformations& transformations) {
  const RestSurface& surface = *surface_;
  std::copy(constants_.begin(), constants_.end(), matrix_.valuePtr());
  rhs_.setZero();
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
    blocks_.addEdge(e, K, matrix_.valuePtr());
    rhs_.row(low) -= g.transpose();
    rhs_.row(high) += g.transpose();
  }
  addTargets();
}

void VertexSystem::assemblePoisson() {
  const RestSurface& surface = *surface_;
  std::copy(constants_.begin(), constants_.end(), matrix_.valuePtr());
  rhs_.setZero();
  for (Index e = 0; e < surface.edges.count(); ++e) {
    const Mat3 K = surface.edges.faceCountAt(e) / surface.averageLength * Mat3::Identity();
    blocks_.addEdge(e, K, matrix_.valuePtr());
    const auto [low, high] = surface.edges.ends[e];
    const Eigen::RowVector3d g = K(0, 0) * (surface.mesh.positions.row(high) - surface.mesh.positions.row(low));
    rhs_.row(low) -= g;
    rhs_.row(high) += g;
  }
  addTargets();
}

void VertexSystem::addTargets() {
  for (const PointRow& row : rows_) {
    for (int i = 0; i < row.count; ++i)
      rhs_.row(row.vertices[i]) += row.stiffness * row.coefficients[i] * row.target.transpose();
  }
}

void VertexSystem::beginPrepare() {
  cholesky_.beginAnalyze(matrix_, {.coordinates = &surface_->mesh.positions, .blockSize = 3});
  stage_ = Stage::analyzing;
}

Status VertexSystem::prepareNext(double& share) {
  constexpr double kAnalyzing = 0.3;  // share of the work
  Status status;
  if (stage_ == Stage::analyzing) {
    share = kAnalyzing * cholesky_.analyzeNext();
    if (share < kAnalyzing) return {};
    cholesky_.beginFactorize(matrix_, true);
    stage_ = Stage::factoring;
  } else if (stage_ == Stage::factoring) {
    status = cholesky_.factorizeNext(share);
    if (share == 1)
      stage_ = Stage::done;
    else
      share = kAnalyzing + (1 - kAnalyzing) * share;
  } else {
    share = 1;
  }
  return status;
}

Status VertexSystem::solve(double tolerance, Points& positions) {
  Eigen::Map<Vector> x(positions.data(), positions.size());
  residual_ = Eigen::Map<const Vector>(rhs_.data(), rhs_.size());
  residual_.noalias() -= matrix_.selfadjointView<Eigen::Lower>() * x;
  ConjugateGradients::Report report;
  for (int attempt = 0; attempt < 2; ++attempt) {
    correction_.setZero();
    Status status = cholesky_.solveRefined(matrix_, residual_, correction_, {tolerance, kMostIterations}, &report);
    if (!status.ok()) return status;
    if (report.reached || attempt > 0) break;
    if (status = cholesky_.factorize(matrix_, true); !status.ok()) return status;
  }
  x += correction_;
  return {};
}

}  // namespace whittle
