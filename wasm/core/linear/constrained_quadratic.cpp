#include "linear/constrained_quadratic.h"

#include <algorithm>
#include <utility>

#include "linear/plane_system.h"

namespace whittle {

namespace {

constexpr Index kHeld = -1, kOnPlane = -2;

/// Shares of the work: what is done after the analysis, by whether the order is known, and after the factorization if
/// there are planes.
constexpr double kAnalyzed = 0.4, kAnalyzedInOrder = 0.15, kFactored = 0.9;

}  // namespace

/// What is needed until the system is factored.
struct ConstrainedQuadratic::Preparation {
  SparseMatrix A;  // until its free block is taken
  Ordering ordering;
  std::vector<RowPlane> planes;
  std::vector<Index> rows;  // of A in the free block: free ones, then those on planes
  SparseMatrix freeBlock;   // lower triangle
  Points coordinates;       // of its rows, where they are known
  enum class Stage { block, analysis, factorization, planes } stage = Stage::block;

  void takeFreeBlock(const std::vector<Index>& held, const std::vector<HeldRow>& onPlanes);
  void fillInOrder(const std::vector<Index>& placeOf);
  void fillAnyhow(const std::vector<Index>& placeOf);
  Ordering orderingOfBlock(Index kept);
};

ConstrainedQuadratic::ConstrainedQuadratic() = default;
ConstrainedQuadratic::~ConstrainedQuadratic() = default;
ConstrainedQuadratic::ConstrainedQuadratic(ConstrainedQuadratic&&) noexcept = default;
ConstrainedQuadratic& ConstrainedQuadratic::operator=(ConstrainedQuadratic&&) noexcept = default;

/// @param onPlanes rows on planes that have freedom left
void ConstrainedQuadratic::Preparation::takeFreeBlock(const std::vector<Index>& held,
                                                      const std::vector<HeldRow>& onPlanes) {
  std::vector<Index> placeOf(A.rows(), 0);
  for (const Index row : held) placeOf[row] = kHeld;
  for (const HeldRow& each : onPlanes) placeOf[each.row] = kOnPlane;
  for (Index row = 0; row < A.rows(); ++row) {
    if (placeOf[row] < 0) continue;
    placeOf[row] = static_cast<Index>(rows.size());
    rows.push_back(row);
  }
  for (const HeldRow& each : onPlanes) {
    placeOf[each.row] = static_cast<Index>(rows.size());
    rows.push_back(each.row);
  }
  freeBlock.resize(static_cast<Index>(rows.size()), static_cast<Index>(rows.size()));
  if (onPlanes.empty()) {
    fillInOrder(placeOf);
  } else {
    fillAnyhow(placeOf);
  }
  A = SparseMatrix();
}

/// Rows that keep their order fill the block front to back.
void ConstrainedQuadratic::Preparation::fillInOrder(const std::vector<Index>& placeOf) {
  freeBlock.reserve(A.nonZeros());
  for (Index column = 0; column < freeBlock.cols(); ++column) {
    freeBlock.startVec(column);
    for (SparseMatrix::InnerIterator entry(A, rows[column]); entry; ++entry) {
      const Index row = placeOf[entry.row()];
      if (row >= column) freeBlock.insertBack(row, column) = entry.value();
    }
  }
  freeBlock.finalize();
}

void ConstrainedQuadratic::Preparation::fillAnyhow(const std::vector<Index>& placeOf) {
  std::vector<Eigen::Triplet<double, Index>> entries;
  entries.reserve(A.nonZeros());
  for (Index column = 0; column < A.cols(); ++column) {
    for (SparseMatrix::InnerIterator entry(A, column); entry; ++entry) {
      if (entry.row() < column || placeOf[column] < 0 || placeOf[entry.row()] < 0) continue;
      const auto [low, high] = std::minmax(placeOf[column], placeOf[entry.row()]);
      entries.emplace_back(high, low, entry.value());
    }
  }
  freeBlock.setFromTriplets(entries.begin(), entries.end());
}

Ordering ConstrainedQuadratic::Preparation::orderingOfBlock(Index kept) {
  Ordering result = ordering;
  result.kept = kept;
  if (!ordering.coordinates) return result;
  coordinates.resize(rows.size(), 3);
  for (std::size_t i = 0; i < rows.size(); ++i) coordinates.row(i) = ordering.coordinates->row(rows[i]);
  result.coordinates = &coordinates;
  return result;
}

void ConstrainedQuadratic::beginPrepare(SparseMatrix A, std::vector<Index> held, const Ordering& ordering,
                                        std::vector<RowPlane> planes) {
  held_ = std::move(held);
  preparation_ = std::make_unique<Preparation>();
  preparation_->A = std::move(A);
  preparation_->ordering = ordering;
  preparation_->planes = std::move(planes);
}

/// Joins planes, takes the free block and begins its analysis, if there is something to solve.
Status ConstrainedQuadratic::begin() {
  Preparation& now = *preparation_;
  std::vector<HeldRow> onPlanes;
  if (Status status = joinPlanes(std::move(now.planes), onPlanes); !status.ok()) return status;
  std::vector<bool> isHeld(now.A.rows(), false);
  for (const Index row : held_) isHeld[row] = true;
  std::vector<HeldRow> movable;
  for (const HeldRow& each : onPlanes) {
    if (isHeld[each.row]) continue;
    if (each.freedom > 0) movable.push_back(each);
    if (each.freedom == 0) held_.push_back(each.row);
  }
  const Index spare = static_cast<Index>(paddedRows(static_cast<Index>(now.A.rows()))) - 1;
  now.takeFreeBlock(held_, movable);
  allHeld_ = now.rows.empty();
  if (!allHeld_) {
    cholesky_.beginAnalyze(now.freeBlock, now.orderingOfBlock(static_cast<Index>(movable.size())), now.rows, spare);
  }
  planeSystem_.reset();
  if (!movable.empty()) planeSystem_ = std::make_unique<PlaneSystem>(std::move(movable));
  return {};
}

Status ConstrainedQuadratic::prepareNext(double& share, double work) {
  using Stage = Preparation::Stage;
  Preparation& now = *preparation_;
  const double analyzed = now.ordering.isOrdered ? kAnalyzedInOrder : kAnalyzed;
  const double factored = planeSystem_ ? kFactored : 1;
  Status status;
  double done = 0;
  switch (now.stage) {
    case Stage::block:
      status = begin();
      share = !status.ok() || allHeld_ ? 1 : 0;
      now.stage = Stage::analysis;
      break;
    case Stage::analysis:
      done = cholesky_.analyzeNext(work);
      share = analyzed * done;
      if (done < 1) break;
      now.coordinates.resize(0, 3);
      cholesky_.beginFactorize(now.freeBlock);
      now.stage = Stage::factorization;
      break;
    case Stage::factorization:
      status = cholesky_.factorizeNext(done, work);
      share = done == 1 ? factored : analyzed + (factored - analyzed) * done;
      if (!status.ok()) share = 1;
      if (done < 1 || share == 1) break;
      planeSystem_->beginPrepare(cholesky_.takeSchurComplement());
      now.stage = Stage::planes;
      break;
    case Stage::planes:
      status = planeSystem_->prepareNext(done, work);
      share = done == 1 ? 1 : factored + (1 - factored) * done;
      break;
  }
  if (share == 1) preparation_.reset();
  return status;
}

Status ConstrainedQuadratic::prepare(SparseMatrix A, const std::vector<Index>& held, const Ordering& ordering,
                                     const std::vector<RowPlane>& planes) {
  beginPrepare(std::move(A), held, ordering, planes);
  Status status;
  for (double share = 0; share < 1;) status = prepareNext(share);
  return status;
}

void ConstrainedQuadratic::correct(LaneRows& residual) {
  for (const Index row : held_) residual[row] = {};
  if (allHeld_) return;
  if (!planeSystem_) {
    cholesky_.solve(residual.data());
    return;
  }
  cholesky_.forward(residual.data());
  planeSystem_->solve(residual.data());
  cholesky_.backward(residual.data());
}

}  // namespace whittle
