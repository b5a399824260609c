#include "methods/alternating/transformation_system.h"

#include <algorithm>
#include <cmath>

#include "simd/lane_algebra.h"

namespace whittle {

namespace {

using Block = MatrixFieldSystem::Block;

constexpr Index kSliceOfFaces = 8000;

/// P = ê êᵀ + ω d̂ d̂ᵀ of a pair of faces.
Mat3 couplingOf(const Hinge& hinge, double similarity) {
  return hinge.along * hinge.along.transpose() + similarity * hinge.across * hinge.across.transpose();
}

/// Adds I ⊗ Q: Q on each row of a face's matrix.
void addOnRows(const Mat3& Q, Block& block) {
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) block.block<3, 3>(3 * i, 3 * j).diagonal().array() += Q(i, j);
  }
}

/// The gradient factors of a row of nine: n·(τ u) has n uᵀ.
void addOuter(double weight, const Vec3& n, const Vec3& u, Block& block) {
  Eigen::Matrix<double, 9, 1> factors;
  for (int j = 0; j < 3; ++j) factors.segment<3>(3 * j) = u[j] * n;
  block += weight * factors * factors.transpose();
}

}  // namespace

void TransformationSystem::shape(const RestSurface& surface, const EnergyWeights& weights) {
  surface_ = &surface;
  weights_ = weights;
  residual_.resize(surface.faceCount());
  rows_.assign(3 * static_cast<std::size_t>(surface.faceCount()), {});
  correction_ = rows_;
  addHinges();
  nextFace_ = 0;
}

Status TransformationSystem::prepareNext(double& share) {
  const Index end = std::min(nextFace_ + kSliceOfFaces, surface_->faceCount());
  for (; nextFace_ < end; ++nextFace_) {
    if (Status status = setDiagonal(nextFace_); !status.ok()) return status;
  }
  share = static_cast<double>(nextFace_) / surface_->faceCount();
  return {};
}

void TransformationSystem::addHinges() {
  std::vector<std::pair<Index, Index>> pairs;
  for (const Hinge& hinge : surface_->hinges) pairs.push_back(std::minmax(hinge.first, hinge.second));
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  system_.shape(graphOf(surface_->faceCount(), pairs));

  const Graph& graph = system_.graph();
  std::vector<Mat3> couplings(graph.neighbours.size(), Mat3::Zero());
  couplingSums_.assign(surface_->faceCount(), Mat3::Zero());
  const auto add = [&](Index face, Index other, const Mat3& P) {
    couplingSums_[face] += P;
    for (Index place = graph.start[face]; place < graph.start[face + 1]; ++place) {
      if (graph.neighbours[place] == other) couplings[place] += P;
    }
  };
  for (const Hinge& hinge : surface_->hinges) {
    const Mat3 P = couplingOf(hinge, weights_.similarity * hinge.similarity);
    add(hinge.first, hinge.second, P);
    add(hinge.second, hinge.first, P);
  }
  for (Index place = 0; place < static_cast<Index>(couplings.size()); ++place)
    system_.setCoupling(place, couplings[place]);
}

Status TransformationSystem::setDiagonal(Index f) {
  const RestSurface& surface = *surface_;
  const Vec3 c = surface.keptDirections.row(f).transpose();
  const Mat3 edges = surface.halfEdges.middleRows<3>(3 * f).transpose() * surface.halfEdges.middleRows<3>(3 * f);
  Block block = Block::Zero();
  addOnRows(couplingSums_[f] + edges / surface.averageLength + weights_.regularizer * Mat3::Identity() +
                weights_.keptRadius * c * c.transpose(),
            block);
  for (int i = 0; i < 3; ++i) {
    const Index h = 3 * f + i;
    const Vec3 u = surface.halfEdges.row(h).transpose() / surface.lengths[h];
    addOuter(weights_.normal, surface.edgeNormals.row(h).transpose(), u, block);
    if (surface.sphericity[f] > 0) {
      const Vec3 w = -surface.halfEdges.row(3 * f + (i + 2) % 3).transpose() / surface.lengths[3 * f + (i + 2) % 3];
      const Mat3 R = cornerRotation(surface, f, i);
      for (int axis = 0; axis < 3; ++axis) {
        Eigen::Matrix<double, 9, 1> factors;
        for (int j = 0; j < 3; ++j)
          factors.segment<3>(3 * j) = w[j] * Vec3::Unit(axis) - u[j] * R.row(axis).transpose();
        block += surface.sphericity[f] * factors * factors.transpose();
      }
    }
  }
  return system_.setDiagonal(f, block);
}

void TransformationSystem::residualOf(const Points& halfEdges, const Transformations& transformations) {
  const RestSurface& surface = *surface_;
  for (Index f = 0; f < surface.faceCount(); ++f) {
    const Mat3& tau = transformations[f];
    const Vec3 c = surface.keptDirections.row(f).transpose();
    Mat3 r = weights_.regularizer * (Mat3::Identity() - tau) + weights_.keptRadius * (c - tau * c) * c.transpose();
    for (int i = 0; i < 3; ++i) {
      const Index h = 3 * f + i;
      const Vec3 rest = surface.halfEdges.row(h).transpose(), e = halfEdges.row(h).transpose();
      const Vec3 u = rest / surface.lengths[h], n = surface.edgeNormals.row(h).transpose();
      r += (e - tau * rest) / surface.averageLength * rest.transpose();
      r -= weights_.normal * n.dot(tau * u) * n * u.transpose();
      if (surface.sphericity[f] > 0) {
        const Vec3 w = -surface.halfEdges.row(3 * f + (i + 2) % 3).transpose() / surface.lengths[3 * f + (i + 2) % 3];
        const Mat3 R = cornerRotation(surface, f, i);
        const Vec3 gap = surface.sphericity[f] * (tau * w - R * (tau * u));
        r -= gap * w.transpose() - R.transpose() * gap * u.transpose();
      }
    }
    residual_[f] = r;
  }
  for (const Hinge& hinge : surface.hinges) {
    const Mat3 change = transformations[hinge.first] - transformations[hinge.second];
    const Mat3 force = change * hinge.along * hinge.along.transpose() +
                       weights_.similarity * hinge.similarity * change * hinge.across * hinge.across.transpose();
    residual_[hinge.first] -= force;
    residual_[hinge.second] += force;
  }
}

void TransformationSystem::beginSolve(const Points& halfEdges, const MatrixFieldSystem::Limits& limits,
                                      Transformations& transformations) {
  const auto toRows = [&](const auto& matrixOf) {
    for (Index f = 0; f < surface_->faceCount(); ++f) {
      const Mat3 matrix = matrixOf(f);
      for (int j = 0; j < 3; ++j) setRow(rows_[3 * f + j], matrix.col(j));
    }
  };
  // The right-hand side alone says what is small.
  toRows([&](Index f) -> Mat3 {
    const auto rest = surface_->halfEdges.middleRows<3>(3 * f), e = halfEdges.middleRows<3>(3 * f);
    const Vec3 c = surface_->keptDirections.row(f).transpose();
    return e.transpose() * rest / surface_->averageLength + weights_.regularizer * Mat3::Identity() +
           weights_.keptRadius * c * c.transpose();
  });
  const double scale = system_.squaredNorm(rows_);
  residualOf(halfEdges, transformations);
  toRows([&](Index f) -> Mat3 { return residual_[f]; });
  solved_ = &transformations;
  system_.beginSolve(rows_, scale, limits, correction_);
}

bool TransformationSystem::solveNext() {
  if (!system_.solveNext()) return false;
  for (Index f = 0; f < surface_->faceCount(); ++f) {
    for (int j = 0; j < 3; ++j) {
      const LaneRow& row = correction_[3 * f + j];
      (*solved_)[f].col(j) += Vec3(row.x, row.y, row.z);
    }
  }
  return true;
}

double TransformationSystem::energy(const Transformations& transformations) const {
  const RestSurface& surface = *surface_;
  double energy = 0;
  for (Index f = 0; f < surface.faceCount(); ++f) {
    const Mat3& tau = transformations[f];
    const Vec3 c = surface.keptDirections.row(f).transpose();
    energy += weights_.regularizer * (tau - Mat3::Identity()).squaredNorm() +
              weights_.keptRadius * (tau * c - c).squaredNorm();
    for (int i = 0; i < 3; ++i) {
      const Index h = 3 * f + i;
      const Vec3 u = surface.halfEdges.row(h).transpose() / surface.lengths[h];
      const double across = surface.edgeNormals.row(h).dot((tau * u).transpose());
      energy += weights_.normal * across * across;
      if (surface.sphericity[f] > 0) {
        const Vec3 w = -surface.halfEdges.row(3 * f + (i + 2) % 3).transpose() / surface.lengths[3 * f + (i + 2) % 3];
        energy += surface.sphericity[f] * (tau * w - cornerRotation(surface, f, i) * (tau * u)).squaredNorm();
      }
    }
  }
  for (const Hinge& hinge : surface.hinges) {
    const Mat3 change = transformations[hinge.first] - transformations[hinge.second];
    energy += (change * hinge.along).squaredNorm() +
              weights_.similarity * hinge.similarity * (change * hinge.across).squaredNorm();
  }
  return energy;
}

}  // namespace whittle
