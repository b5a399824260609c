#include <doctest/doctest.h>

#include <Eigen/Dense>

#include "linear/matrix_field_system.h"
#include "linear/vector_field_system.h"
#include "simd/lane_algebra.h"
#include "support/allocations.h"
#include "support/shapes.h"

using namespace whittle;
using namespace whittle::testing;

namespace {

constexpr Index kNodes = 40;

/// A ring of nodes with chords: every node has four neighbours.
std::vector<std::array<Index, 2>> ringWithChords() {
  std::vector<std::array<Index, 2>> pairs;
  for (Index v = 0; v < kNodes; ++v) {
    for (const Index step : {1, 7}) {
      const auto [low, high] = std::minmax({v, (v + step) % kNodes});  // of copies
      pairs.push_back({low, high});
    }
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

/// A positive definite 3×3 matrix.
Mat3 somePositive(Noise& noise) {
  const Mat3 M = noise.matrix();
  return M * M.transpose() + 0.1 * Mat3::Identity();
}

}  // namespace

TEST_CASE("a system of vectors is solved as a dense one, also after its values have changed") {
  Noise noise;
  const auto pairs = ringWithChords();
  Points coordinates(kNodes, 3);
  for (Index v = 0; v < kNodes; ++v) coordinates.row(v) = noise.direction().transpose();
  VectorFieldSystem system;
  system.shape(kNodes, pairs);
  Eigen::MatrixXd A;
  const auto fill = [&](double scale) {
    A = Eigen::MatrixXd::Zero(3 * kNodes, 3 * kNodes);
    std::fill(system.diagonal().begin(), system.diagonal().end(), Mat3::Identity());
    A.diagonal().setOnes();
    for (Index p = 0; p < system.pairCount(); ++p) {
      // Stretched springs: K (e·e), and a part of the coupling that is not symmetric.
      const auto [low, high] = pairs[p];
      const Mat3 K = scale * somePositive(noise), skew = noise.matrix() - noise.matrix().transpose();
      const Mat3 coupling = -K + 0.1 * (skew - skew.transpose());
      system.couplings()[p] = coupling;
      system.diagonal()[low] += K + Mat3::Identity();
      system.diagonal()[high] += K + Mat3::Identity();
      A.block<3, 3>(3 * high, 3 * low) += coupling;
      A.block<3, 3>(3 * low, 3 * high) += coupling.transpose();
      for (const Index v : {low, high}) A.block<3, 3>(3 * v, 3 * v) += K + Mat3::Identity();
    }
  };
  const auto check = [&] {
    Points B(kNodes, 3), X = Points::Zero(kNodes, 3);
    for (Index v = 0; v < kNodes; ++v) B.row(v) = noise.direction().transpose();
    system.beginImprove(B, 1e-5, 500, X);
    bool isDone = false;
    while (!isDone) REQUIRE(system.improveNext(isDone).ok());
    const Eigen::VectorXd exact = A.ldlt().solve(Eigen::Map<const Eigen::VectorXd>(B.data(), B.size()));
    CHECK((Eigen::Map<const Eigen::VectorXd>(X.data(), X.size()) - exact).norm() < 1e-4 * exact.norm());
  };
  fill(1);
  system.beginPrepare(coordinates);
  for (double share = 0; share < 1;) REQUIRE(system.prepareNext(share).ok());
  check();
  fill(300);
  check();
}

TEST_CASE("a system of matrices is solved as a dense one, and allocates nothing") {
  Noise noise;
  std::vector<std::pair<Index, Index>> edges;
  for (const auto& [low, high] : ringWithChords()) edges.emplace_back(low, high);
  MatrixFieldSystem system;
  system.shape(graphOf(kNodes, edges));
  const Graph& graph = system.graph();
  Eigen::MatrixXd A = Eigen::MatrixXd::Zero(9 * kNodes, 9 * kNodes);
  std::vector<MatrixFieldSystem::Block> diagonal(kNodes, 1e-2 * MatrixFieldSystem::Block::Identity());
  // (τ_t − τ_s) P on rows: entry (column j, row i) of a node is number 3j + i.
  for (Index t = 0; t < kNodes; ++t) {
    for (Index place = graph.start[t]; place < graph.start[t + 1]; ++place) {
      const Index s = graph.neighbours[place];
      const Vec3 d = Vec3(std::sin(t + s), std::cos(t * s), 1).normalized();
      const Mat3 P = d * d.transpose();
      system.setCoupling(place, P);
      for (int j = 0; j < 3; ++j) {
        for (int k = 0; k < 3; ++k) {
          for (int i = 0; i < 3; ++i) {
            diagonal[t](3 * j + i, 3 * k + i) += P(j, k);
            A(9 * t + 3 * j + i, 9 * s + 3 * k + i) -= P(j, k);
          }
        }
      }
    }
    Eigen::Matrix<double, 9, 1> row;
    for (int i = 0; i < 9; ++i) row[i] = noise();
    diagonal[t] += row * row.transpose();
    REQUIRE(system.setDiagonal(t, diagonal[t]).ok());
    A.block<9, 9>(9 * t, 9 * t) = diagonal[t];
  }
  MatrixRows residual(3 * kNodes), correction(3 * kNodes);
  Eigen::VectorXd b(9 * kNodes);
  for (Index column = 0; column < 3 * kNodes; ++column) {
    b.segment<3>(3 * column) = noise.direction();
    setRow(residual[column], b.segment<3>(3 * column));
  }
  const double scale = system.squaredNorm(residual);
  const long before = allocationCount();
  system.beginSolve(residual, scale, {1e-5, 1000}, correction);
  while (!system.solveNext()) {
  }
  CHECK(allocationCount() == before);
  const Eigen::VectorXd exact = A.ldlt().solve(b);
  double error = 0;
  for (Index column = 0; column < 3 * kNodes; ++column) {
    const LaneRow& row = correction[column];
    error += (Vec3(row.x, row.y, row.z) - exact.segment<3>(3 * column)).squaredNorm();
  }
  CHECK(std::sqrt(error) < 1e-3 * exact.norm());
  CHECK_FALSE(system.setDiagonal(0, -MatrixFieldSystem::Block::Identity()).ok());
}
