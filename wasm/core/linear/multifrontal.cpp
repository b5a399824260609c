#include "linear/multifrontal.h"

#include <algorithm>
#include <cstring>

#include "linear/dense_front.h"

namespace whittle {

namespace {

constexpr Index kTile = kFrontPadding + 1;
constexpr double kFrontWork = 1000;  // of a front, however small
constexpr double kTouch = 4;         // of a number that is moved

/// Multiply-adds of a block of columns of a panel, from `first` on, and of what lies to its right.
double factorWork(double rows, double columns, Index first) {
  return kFrontBlock * (columns - first) * (rows - (first + columns) / 2);
}

/// Multiply-adds of an inverse's block of columns that ends before `end`.
double invertWork(double rows, double columns, Index end) {
  return kFrontBlock * (columns - end + kFrontBlock) * (rows - (end + columns) / 2);
}

/// Multiply-adds of some columns of an update, from `first` on.
double updateWork(double size, double columns, double first, double width) {
  return columns * width * (size - first - width / 2);
}

}  // namespace

double Multifrontal::workOf(Index columns, Index height) {
  const double size = height - columns;
  const double touched = columns * static_cast<double>(height) + 2 * size * size;
  double work = kFrontWork + kTouch * touched + updateWork(size, columns, 0, size);
  for (Index first = 0; first < columns; first += kFrontBlock) work += factorWork(height, columns, first);
  for (Index end = columns; end > 0; end -= kFrontBlock) work += invertWork(height, columns, end);
  return work;
}

void Multifrontal::begin(const Supernodes& supernodes, std::size_t peakUpdates) {
  supernodes_ = &supernodes;
  stack_.resize(peakUpdates);
  top_ = 0;
  waiting_.clear();
  waiting_.reserve(supernodes.count());
  placeOf_.resize(supernodes.newOf.size());
  std::size_t largestFront = 0, widest = 0;
  for (Index s = 0; s < supernodes.count(); ++s) {
    const std::size_t columns = supernodes.columns(s);
    largestFront = std::max(largestFront, columns * supernodes.height(s));
    widest = std::max(widest, columns);
  }
  front_.resize(largestFront + kFrontPadding);
  inverse_.resize(largestFront + kFrontPadding);
  scratch_.resize(widest * widest + kFrontPadding);
}

double* Multifrontal::open(Index s) {
  s_ = s;
  columns_ = supernodes_->columns(s);
  height_ = supernodes_->height(s);
  size_ = height_ - columns_;
  const Index* rows = supernodes_->rowsOf(s);
  for (Index r = 0; r < height_; ++r) placeOf_[rows[r]] = r;
  std::fill_n(front_.begin(), static_cast<std::size_t>(columns_) * height_, 0.0);
  // The new update lies above the children's, which are on top of the stack, until they are taken in.
  update_ = stack_.data() + top_;
  std::fill_n(update_, static_cast<std::size_t>(size_) * size_, 0.0);
  bottom_ = top_;
  enter(Stage::gather);
  return front_.data();
}

void Multifrontal::enter(Stage stage) {
  stage_ = stage;
  at_ = 0;
}

bool Multifrontal::advance(double& work) {
  while (work > 0 && stage_ != Stage::done) {
    switch (stage_) {
      case Stage::gather: work -= gather(); break;
      case Stage::factor:
        if (!factorBlock(work)) return false;
        break;
      case Stage::update: work -= updateColumns(work); break;
      case Stage::invert: work -= invertBlock(); break;
      case Stage::done: break;
    }
  }
  return true;
}

/// Takes in the update of a child, if there is one left.
double Multifrontal::gather() {
  if (waiting_.empty() || supernodes_->parent[waiting_.back()] != s_) {
    enter(Stage::factor);
    return kFrontWork + kTouch * (static_cast<double>(columns_) * height_ + static_cast<double>(size_) * size_);
  }
  const Index child = waiting_.back();
  const std::size_t numbers = static_cast<std::size_t>(updateSize(child)) * updateSize(child);
  bottom_ -= numbers;
  takeUpdate(child, stack_.data() + bottom_);
  waiting_.pop_back();
  return kTouch * static_cast<double>(numbers);
}

void Multifrontal::takeUpdate(Index child, const double* update) {
  const Index size = updateSize(child);
  const Index* rows = supernodes_->rowsOf(child) + supernodes_->columns(child);
  for (Index j = 0; j < size; ++j) {
    const std::ptrdiff_t column = placeOf_[rows[j]];
    const double* source = update + static_cast<std::ptrdiff_t>(j) * size;
    const bool inPanel = column < columns_;
    double* target = inPanel ? front_.data() + column * height_ : update_ + (column - columns_) * size_;
    const Index skipped = inPanel ? 0 : columns_;
    for (Index i = j; i < size; ++i) target[placeOf_[rows[i]] - skipped] += source[i];
  }
}

void Multifrontal::listRemaining(std::vector<Eigen::Triplet<double, Index>>& entries) const {
  const double* update = stack_.data();
  for (const Index s : waiting_) {
    const Index size = updateSize(s);
    const Index* rows = supernodes_->rowsOf(s) + supernodes_->columns(s);
    for (Index j = 0; j < size; ++j, update += size) {
      for (Index i = j; i < size; ++i) entries.emplace_back(rows[i], rows[j], update[i]);
    }
  }
}

bool Multifrontal::factorBlock(double& work) {
  if (!factorPanelBlock(front_.data(), height_, columns_, at_)) return false;
  work -= factorWork(height_, columns_, at_);
  at_ += kFrontBlock;
  if (at_ >= columns_) enter(Stage::update);
  return true;
}

/// Makes as many columns of the update as the work allows, in whole tiles, and puts it where the children's were when
/// it is whole.
double Multifrontal::updateColumns(double work) {
  const double possible = work / (columns_ * std::max(1.0, static_cast<double>(size_ - at_)));
  const Index tiles = static_cast<Index>(std::min<double>(size_, possible)) / kTile;
  const Index first = at_, width = std::min(size_ - first, std::max<Index>(1, tiles) * kTile);
  const double* below = front_.data() + columns_ + first;
  double* corner = update_ + static_cast<std::ptrdiff_t>(first) * (size_ + 1);
  subtractProduct(corner, size_, below, height_, below, height_, size_ - first, width, columns_, true);
  at_ += width;
  if (at_ == size_) {
    const std::size_t numbers = static_cast<std::size_t>(size_) * size_;
    if (size_ > 0) {
      std::memmove(stack_.data() + bottom_, update_, sizeof(double) * numbers);
      waiting_.push_back(s_);
    }
    top_ = bottom_ + numbers;
    beginInverse(front_.data(), inverse_.data(), height_, columns_);
    enter(Stage::invert);
  }
  return updateWork(size_, columns_, first, width);
}

double Multifrontal::invertBlock() {
  const Index end = columns_ - at_;
  invertPanelBlock(front_.data(), inverse_.data(), scratch_.data(), height_, columns_, end);
  at_ += kFrontBlock;
  if (at_ >= columns_) enter(Stage::done);
  return invertWork(height_, columns_, end);
}

}  // namespace whittle
