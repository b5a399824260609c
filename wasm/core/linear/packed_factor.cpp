#include "linear/packed_factor.h"

#include <algorithm>

namespace whittle {

void PackedFactor::shape(const Supernodes& supernodes, const std::vector<Index>& rowOf, Index spare) {
  supernodes_ = &supernodes;
  std::vector<Index> rowAt(rowOf.size());
  for (std::size_t unknown = 0; unknown < rowOf.size(); ++unknown) rowAt[supernodes.newOf[unknown]] = rowOf[unknown];
  Index mostTiles = 0, mostColumns = 0;
  paddedRows_.clear();
  paddedStart_.assign(1, 0);
  tileStart_.assign(1, 0);
  for (Index s = 0; s < supernodes.count(); ++s) {
    const Index* rows = supernodes.rowsOf(s);
    const Index tiles = (supernodes.height(s) + 3) / 4;
    for (Index i = 0; i < supernodes.height(s); ++i) paddedRows_.push_back(rowAt[rows[i]]);
    paddedStart_.push_back(paddedStart_.back() + 4 * tiles);
    paddedRows_.resize(paddedStart_.back(), spare);
    tileStart_.push_back(tileStart_.back() + static_cast<std::size_t>(tiles) * supernodes.columns(s));
    mostTiles = std::max(mostTiles, tiles);
    mostColumns = std::max(mostColumns, supernodes.columns(s));
  }
  tiles_.resize(tileStart_.back());
  scratch_.assign(std::max(3 * mostTiles, mostColumns), {});
}

void PackedFactor::pack(Index s, const double* inverted) {
  packTiles(inverted, supernodes_->height(s), supernodes_->columns(s), tiles_.data() + tileStart_[s]);
}

SolvePanel PackedFactor::panel(Index s) const {
  return {tiles_.data() + tileStart_[s], paddedRows_.data() + paddedStart_[s], supernodes_->columns(s),
          supernodes_->height(s)};
}

void PackedFactor::forward(LaneRow* rows, Index groups, std::ptrdiff_t stride) {
  for (Index s = 0; s < supernodes_->count(); ++s) {
    for (Index g = 0; g < groups; ++g) panelForward(panel(s), rows + g * stride, scratch_.data());
  }
}

void PackedFactor::backward(LaneRow* rows, Index groups, std::ptrdiff_t stride) {
  for (Index s = supernodes_->count() - 1; s >= 0; --s) {
    for (Index g = 0; g < groups; ++g) panelBackward(panel(s), rows + g * stride, scratch_.data());
  }
}

}  // namespace whittle
