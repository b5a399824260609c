#pragma once

#include <vector>

#include "linear/supernodes.h"

namespace whittle {

/// The working memory of a multifrontal factorization: one front at a time and the updates that wait for their parents.
class Multifrontal {
 public:
  /// Starts a factorization. Allocates only what the one before did not need.
  /// @param supernodes to be kept by the caller until the factorization ends
  /// @param peakUpdates largest stack of update matrices, in numbers
  void begin(const Supernodes& supernodes, std::size_t peakUpdates);

  /// Starts supernode s: an empty front.
  double* open(Index s);

  /// Adds the updates of s's children, factors the front to [L11; L21] and leaves its update for the parent. Returns false
  /// if a pivot is not positive. Supernodes come in order.
  bool eliminate(Index s);

  /// [L11⁻¹; −L21 L11⁻¹] of the front just eliminated, column-major.
  const double* inverted(Index s);

 private:
  void takeUpdate(Index child, const double* update, Index parent, double* parentUpdate);
  Index updateSize(Index s) const { return supernodes_->height(s) - supernodes_->columns(s); }

  const Supernodes* supernodes_ = nullptr;
  std::vector<double> front_;    // column-major panel of the current supernode
  std::vector<double> inverse_;  // the same size
  std::vector<double> scratch_;  // columns × columns
  std::vector<double> stack_;    // update matrices, column-major, lower part
  std::size_t top_ = 0;
  std::vector<Index> waiting_;   // supernodes whose updates are on the stack
  std::vector<Index> placeOf_;   // #unknowns: row in the current front
};

}  // namespace whittle
