#pragma once

#include <vector>

#include "linear/supernodes.h"

namespace whittle {

/// Where the entries of A's lower triangle go: from the value array of A into the column-major panels of the
/// supernodes. Made once a pattern.
class EntryPlaces {
 public:
  EntryPlaces() = default;
  EntryPlaces(const SparseMatrix& A, const Supernodes& supernodes);

  /// Adds the entries of supernode s to its panel.
  void add(const double* values, Index s, double* panel) const {
    for (Index e = start_[s]; e < start_[s + 1]; ++e) panel[entries_[e].place] += values[entries_[e].value];
  }

 private:
  struct Entry {
    Index value;  // into A's value array
    Index place;  // in the panel
  };

  void sortEntries(const SparseMatrix& A, Index column, const Supernodes& supernodes, Index* ends);
  void placeInPanel(const Supernodes& supernodes, Index s, const Index* start, Index* placeOf);

  std::vector<Entry> entries_;  // by supernode
  std::vector<Index> start_;    // #supernodes + 1
};

}  // namespace whittle
