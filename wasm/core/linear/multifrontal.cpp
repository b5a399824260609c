#include "linear/multifrontal.h"

#include <algorithm>
#include <cstring>

#include "linear/dense_front.h"

namespace whittle {

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
  std::fill_n(front_.begin(), static_cast<std::size_t>(supernodes_->columns(s)) * supernodes_->height(s), 0.0);
  return front_.data();
}

bool Multifrontal::eliminate(Index s) {
  const Index columns = supernodes_->columns(s), height = supernodes_->height(s);
  const std::size_t size = updateSize(s);
  const Index* rows = supernodes_->rowsOf(s);
  for (Index r = 0; r < height; ++r) placeOf_[rows[r]] = r;

  // The new update lies above the children's, which are on top of the stack, until they are taken in.
  double* update = stack_.data() + top_;
  std::fill_n(update, size * size, 0.0);
  std::size_t bottom = top_;
  while (!waiting_.empty() && supernodes_->parent[waiting_.back()] == s) {
    const Index child = waiting_.back();
    bottom -= static_cast<std::size_t>(updateSize(child)) * updateSize(child);
    takeUpdate(child, stack_.data() + bottom, s, update);
    waiting_.pop_back();
  }
  if (!factorPanel(front_.data(), height, columns)) return false;
  if (size > 0) {
    const double* below = front_.data() + columns;
    subtractProduct(update, size, below, height, below, height, size, size, columns, true);
    std::memmove(stack_.data() + bottom, update, sizeof(double) * size * size);
    waiting_.push_back(s);
  }
  top_ = bottom + size * size;
  return true;
}

void Multifrontal::takeUpdate(Index child, const double* update, Index parent, double* parentUpdate) {
  const Index columns = supernodes_->columns(parent), height = supernodes_->height(parent), size = updateSize(child);
  const Index* rows = supernodes_->rowsOf(child) + supernodes_->columns(child);
  for (Index j = 0; j < size; ++j) {
    const std::ptrdiff_t column = placeOf_[rows[j]];
    const double* source = update + static_cast<std::ptrdiff_t>(j) * size;
    const bool inPanel = column < columns;
    double* target = inPanel ? front_.data() + column * height : parentUpdate + (column - columns) * (height - columns);
    const Index skipped = inPanel ? 0 : columns;
    for (Index i = j; i < size; ++i) target[placeOf_[rows[i]] - skipped] += source[i];
  }
}

const double* Multifrontal::inverted(Index s) {
  invertPanel(front_.data(), inverse_.data(), scratch_.data(), supernodes_->height(s), supernodes_->columns(s));
  return inverse_.data();
}

}  // namespace whittle
