#include "linear/vector_field_system.h"

#include <algorithm>
#include <limits>
#include <numeric>

#include "simd/lane_algebra.h"

namespace whittle {

namespace {

/// Beyond so many iterations the preconditioner is of values too far from the present ones.
constexpr int kMostIterations = 60;
/// One stiff place may make what there is to do a thousand times as much as it was the time before; what was small then
/// still counts.
constexpr double kMostGrowth = 4;
/// Nodes that take part in the iterations of a slice.
constexpr Index kSliceOfNodes = 120000;

}  // namespace

void VectorFieldSystem::shape(Index nodes, std::vector<std::array<Index, 2>> pairs) {
  pairs_ = std::move(pairs);
  diagonal_.assign(nodes, Mat3::Zero());
  couplings_.assign(pairs_.size(), Mat3::Zero());
  start_.assign(nodes + 1, 0);
  for (const auto& [low, high] : pairs_) ++start_[low + 1], ++start_[high + 1];
  std::partial_sum(start_.begin(), start_.end(), start_.begin());
  neighbours_.resize(2 * pairs_.size());
  std::vector<Index> next(start_.begin(), start_.end() - 1);
  for (Index p = 0; p < pairCount(); ++p) {
    const auto [low, high] = pairs_[p];
    neighbours_[next[low]++] = {high, p, false};
    neighbours_[next[high]++] = {low, p, true};
  }
  blocks_.assign(3 * (neighbours_.size() + diagonal_.size()), {});
  residual_.resize(nodes, 3);
  rows_.assign(nodes + 1, {});
  correction_ = rows_;
  gradients_.shape(rows_.size());
}

Index VectorFieldSystem::findPair(Index low, Index high) const {
  return static_cast<Index>(std::lower_bound(pairs_.begin(), pairs_.end(), std::array<Index, 2>{low, high}) -
                            pairs_.begin());
}

void VectorFieldSystem::average() {
  const auto mean = [](const Mat3& block) { return block.trace() / 3; };
  double* const values = mean_.valuePtr();
  Index place = 0, pair = 0;
  for (Index v = 0; v < size(); ++v) {
    values[place++] = mean(diagonal_[v]);
    for (; pair < pairCount() && pairs_[pair][0] == v; ++pair) values[place++] = mean(couplings_[pair]);
  }
}

void VectorFieldSystem::beginPrepare(const Points& coordinates) {
  scale_ = std::numeric_limits<double>::infinity();
  mean_.resize(size(), size());
  mean_.resizeNonZeros(size() + pairCount());
  Index place = 0, pair = 0;
  for (Index v = 0; v < size(); ++v) {
    mean_.outerIndexPtr()[v] = place;
    mean_.innerIndexPtr()[place++] = v;
    for (; pair < pairCount() && pairs_[pair][0] == v; ++pair) mean_.innerIndexPtr()[place++] = pairs_[pair][1];
  }
  mean_.outerIndexPtr()[size()] = place;
  average();
  preparedMean_ = Eigen::Map<const Scalars>(mean_.valuePtr(), mean_.nonZeros());
  isLeft_ = false;
  std::vector<Index> rowOf(size());
  std::iota(rowOf.begin(), rowOf.end(), 0);
  cholesky_.beginAnalyze(mean_, {.coordinates = &coordinates}, std::move(rowOf), size());
  stage_ = Stage::analyzing;
}

Status VectorFieldSystem::prepareNext(double& share) {
  constexpr double kAnalyzing = 0.4;  // share of the work
  Status status;
  share = 1;
  if (stage_ == Stage::analyzing) {
    share = kAnalyzing * cholesky_.analyzeNext();
    if (share < kAnalyzing) return {};
    cholesky_.beginFactorize(mean_, true);
    stage_ = Stage::factoring;
  } else if (stage_ == Stage::factoring) {
    status = cholesky_.factorizeNext(share);
    if (share == 1) stage_ = Stage::done;
    if (share < 1) share = kAnalyzing + (1 - kAnalyzing) * share;
  }
  return status;
}

bool VectorFieldSystem::beginAnew() {
  scale_ = std::numeric_limits<double>::infinity();
  if (isLeft_) {
    isLeft_ = isRefreshing_ = false;
    Eigen::Map<Scalars>(mean_.valuePtr(), mean_.nonZeros()) = preparedMean_;
    cholesky_.beginFactorize(mean_, true);
    stage_ = Stage::factoring;
  }
  return stage_ == Stage::done;
}

void VectorFieldSystem::subtractProduct(const Points& X) {
  for (Index v = 0; v < size(); ++v) residual_.row(v) -= (diagonal_[v] * X.row(v).transpose()).transpose();
  for (Index p = 0; p < pairCount(); ++p) {
    const auto [low, high] = pairs_[p];
    residual_.row(high) -= (couplings_[p] * X.row(low).transpose()).transpose();
    residual_.row(low) -= X.row(high) * couplings_[p];
  }
}

void VectorFieldSystem::toSingle() {
  LaneRow* row = blocks_.data();
  for (Index v = 0; v < size(); ++v) {
    // What the couplings leave of the node's own block: for stiff systems it is small, and x_w − x_v loses nothing.
    Mat3 rest = diagonal_[v];
    for (Index place = start_[v]; place < start_[v + 1]; ++place) {
      const Mat3& block = couplings_[neighbours_[place].pair];
      rest += neighbours_[place].isLower ? block : Mat3(block.transpose());
    }
    for (int j = 0; j < 3; ++j) setRow(*row++, rest.col(j));
    for (Index place = start_[v]; place < start_[v + 1]; ++place) {
      const Mat3& block = couplings_[neighbours_[place].pair];
      for (int j = 0; j < 3; ++j)
        setRow(*row++, neighbours_[place].isLower ? Vec3(block.col(j)) : Vec3(block.row(j).transpose()));
    }
  }
}

double VectorFieldSystem::apply(const LaneRows& x, LaneRows& y) const {
  DoubleLanes dot = {0, 0, 0, 0};
  const LaneRow* block = blocks_.data();
  const auto product = [&block](Lanes of) {
    LaneRow row;
    store(&row, of);
    const Lanes sum =
        load(block) * loadSplat(&row.x) + load(block + 1) * loadSplat(&row.y) + load(block + 2) * loadSplat(&row.z);
    block += 3;
    return sum;
  };
  for (Index v = 0; v < size(); ++v) {
    const Lanes own = load(&x[v]);
    Lanes sum = product(own);
    for (Index place = start_[v]; place < start_[v + 1]; ++place)
      sum += product(load(&x[neighbours_[place].node]) - own);
    dot += toDouble(own * sum);
    store(&y[v], sum);
  }
  return sumOf(dot);
}

double VectorFieldSystem::precondition(const LaneRows& r, LaneRows& z) {
  z = r;
  cholesky_.solve(z.data());
  z.back() = {};
  return LaneGradients::dot(r, z);
}

void VectorFieldSystem::beginImprove(const Points& B, double tolerance, int iterations, Points& X) {
  rhs_ = &B;
  X_ = &X;
  tolerance_ = tolerance;
  left_ = iterations;
  isFresh_ = isRefreshing_ = false;
  toSingle();
  beginDescent();
  scale_ = std::min(first_, kMostGrowth * scale_);
}

void VectorFieldSystem::beginDescent() {
  residual_ = *rhs_;
  subtractProduct(*X_);
  for (Index v = 0; v < size(); ++v) setRow(rows_[v], residual_.row(v).transpose());
  rows_.back() = {};
  most_ = isFresh_ ? left_ : std::min(left_, kMostIterations);
  first_ = gradients_.begin(rows_, correction_, [this](const LaneRows& r, LaneRows& z) { return precondition(r, z); });
}

Status VectorFieldSystem::improveNext(bool& isDone) {
  isDone = false;
  if (isRefreshing_) {
    double share = 1;
    if (Status status = cholesky_.factorizeNext(share); !status.ok() || share < 1) return status;
    isRefreshing_ = false;
    isFresh_ = true;
    beginDescent();
    return {};
  }
  const double small = tolerance_ * tolerance_ * std::min(first_, scale_);
  for (Index work = 0; work < kSliceOfNodes && most_ > 0 && gradients_.squared() > small; work += size()) {
    const bool isBetter = gradients_.iterate(
        rows_, correction_, [this](const LaneRows& x, LaneRows& y) { return apply(x, y); },
        [this](const LaneRows& r, LaneRows& z) { return precondition(r, z); });
    --most_, --left_;
    if (!isBetter) most_ = left_ = 0;
  }
  const bool isSmall = !(gradients_.squared() > small);
  if (most_ > 0 && !isSmall) return {};
  for (Index v = 0; v < size(); ++v)
    X_->row(v) += Eigen::RowVector3d(correction_[v].x, correction_[v].y, correction_[v].z);
  isDone = isSmall || isFresh_ || left_ <= 0;
  if (isDone) return {};
  average();
  cholesky_.beginFactorize(mean_, true);
  isLeft_ = isRefreshing_ = true;
  return {};
}

}  // namespace whittle
