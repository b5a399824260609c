#include "linear/matrix_field_system.h"

#include <Eigen/Cholesky>

namespace whittle {

namespace {

/// Nodes that take part in the iterations of a slice.
constexpr Index kSliceOfNodes = 100000;

/// y = B x of a node for a block of 81 numbers. Each load of three of them takes the next one along, and the spare lane
/// is cleared at the end.
inline void multiply(const float* block, const LaneRow* x, Lanes y[3]) {
  constexpr LaneMask kThree = {-1, -1, -1, 0};
  for (int j = 0; j < 3; ++j) y[j] = splat(0);
  for (int k = 0; k < 3; ++k) {
    const float components[3] = {x[k].x, x[k].y, x[k].z};
    for (int i = 0; i < 3; ++i, block += 9) {
      const Lanes c = loadSplat(components + i);
      for (int j = 0; j < 3; ++j) y[j] += c * load(block + 3 * j);
    }
  }
  for (int j = 0; j < 3; ++j) y[j] = keep(kThree, y[j]);
}

void store(float* numbers, const MatrixFieldSystem::Block& block) {
  Eigen::Map<Eigen::Matrix<float, 9, 9>> columns(numbers);
  columns = block.cast<float>();
}

}  // namespace

void MatrixFieldSystem::shape(Graph graph) {
  graph_ = std::move(graph);
  diagonal_.assign(kBlockSize * static_cast<std::size_t>(size()) + 1, 0);  // the last load takes one along
  inverse_ = diagonal_;
  couplings_.assign(graph_.neighbours.size(), {});
  gradients_.shape(3 * static_cast<std::size_t>(size()));
}

Status MatrixFieldSystem::setDiagonal(Index node, const Block& block) {
  const Eigen::LLT<Block> cholesky(block);
  if (cholesky.info() != Eigen::Success)
    return Status::failure(Code::numericalFailure, "a face is too thin to compute with; repair the mesh first");
  Block rest = block;
  for (Index place = graph_.start[node]; place < graph_.start[node + 1]; ++place) {
    const Coupling& P = couplings_[place];
    const double sums[3][3] = {{P.xx, P.xy, P.xz}, {P.xy, P.yy, P.yz}, {P.xz, P.yz, P.zz}};
    for (Index j = 0; j < 3; ++j) {
      for (Index k = 0; k < 3; ++k) rest.block<3, 3>(3 * j, 3 * k).diagonal().array() -= sums[j][k];
    }
  }
  store(&diagonal_[kBlockSize * static_cast<std::size_t>(node)], rest);
  store(&inverse_[kBlockSize * static_cast<std::size_t>(node)], cholesky.solve(Block::Identity()));
  return {};
}

void MatrixFieldSystem::setCoupling(Index place, const Mat3& P) {
  const auto entry = [&](int i, int j) { return static_cast<float>(P(i, j)); };
  couplings_[place] = {entry(0, 0), entry(0, 1), entry(0, 2), entry(1, 1), entry(1, 2), entry(2, 2)};
}

double MatrixFieldSystem::apply(const MatrixRows& x, MatrixRows& y) const {
  DoubleLanes dot = {0, 0, 0, 0};
  for (Index t = 0; t < size(); ++t) {
    Lanes sums[3];
    const LaneRow* const own = &x[3 * t];
    multiply(&diagonal_[kBlockSize * static_cast<std::size_t>(t)], own, sums);
    for (Index place = graph_.start[t]; place < graph_.start[t + 1]; ++place) {
      const Coupling& P = couplings_[place];
      const LaneRow* neighbour = &x[3 * graph_.neighbours[place]];
      const Lanes a = load(neighbour) - load(own), b = load(neighbour + 1) - load(own + 1),
                  c = load(neighbour + 2) - load(own + 2);
      const Lanes xy = loadSplat(&P.xy), xz = loadSplat(&P.xz), yz = loadSplat(&P.yz);
      sums[0] -= a * loadSplat(&P.xx) + b * xy + c * xz;
      sums[1] -= a * xy + b * loadSplat(&P.yy) + c * yz;
      sums[2] -= a * xz + b * yz + c * loadSplat(&P.zz);
    }
    for (int j = 0; j < 3; ++j) {
      dot += toDouble(load(own + j) * sums[j]);
      whittle::store(&y[3 * t + j], sums[j]);
    }
  }
  return sumOf(dot);
}

double MatrixFieldSystem::precondition(const MatrixRows& r, MatrixRows& z) const {
  DoubleLanes sum = {0, 0, 0, 0};
  for (Index t = 0; t < size(); ++t) {
    Lanes columns[3];
    multiply(&inverse_[kBlockSize * static_cast<std::size_t>(t)], &r[3 * t], columns);
    for (int j = 0; j < 3; ++j) {
      sum += toDouble(load(&r[3 * t + j]) * columns[j]);
      whittle::store(&z[3 * t + j], columns[j]);
    }
  }
  return sumOf(sum);
}

double MatrixFieldSystem::squaredNorm(const MatrixRows& b) const {
  double sum = 0;
  for (Index t = 0; t < size(); ++t) {
    Lanes columns[3];
    multiply(&inverse_[kBlockSize * static_cast<std::size_t>(t)], &b[3 * t], columns);
    for (int j = 0; j < 3; ++j) sum += sumOf(toDouble(load(&b[3 * t + j]) * columns[j]));
  }
  return sum;
}

void MatrixFieldSystem::beginSolve(MatrixRows& residual, double squaredScale, const Limits& limits,
                                   MatrixRows& correction) {
  residual_ = &residual;
  correction_ = &correction;
  small_ = limits.residual * limits.residual * squaredScale;
  left_ = limits.iterations;
  gradients_.begin(residual, correction, [this](const MatrixRows& r, MatrixRows& z) { return precondition(r, z); });
}

bool MatrixFieldSystem::solveNext() {
  for (Index work = 0; work < kSliceOfNodes && left_ > 0 && gradients_.squared() > small_; work += size(), --left_) {
    const bool isBetter = gradients_.iterate(
        *residual_, *correction_, [this](const MatrixRows& x, MatrixRows& y) { return apply(x, y); },
        [this](const MatrixRows& r, MatrixRows& z) { return precondition(r, z); });
    if (!isBetter) left_ = 1;
  }
  return left_ <= 0 || gradients_.squared() <= small_;
}

}  // namespace whittle
