#pragma once

#include <vector>

#include "linear/supernodes.h"

namespace whittle {

/// The working memory of a multifrontal factorization: one front at a time and the updates that wait for their parents.
/// A front is worked on piece by piece, because the last ones can take longer than a caller wants to wait.
class Multifrontal {
 public:
  /// Starts a factorization. Allocates only what the one before did not need.
  /// @param supernodes to be kept by the caller until the factorization ends
  /// @param peakUpdates largest stack of update matrices, in numbers
  void begin(const Supernodes& supernodes, std::size_t peakUpdates);

  /// Opens supernode s with an empty front. Supernodes come in order.
  double* open(Index s);

  /// Works on the open front: adds the updates of s's children, factors the front to [L11; L21], leaves its update for
  /// the parent, and inverts. Returns false if a pivot is not positive.
  /// @param work what may be spent, > 0; what was spent is taken from it
  bool advance(double& work);
  bool isDone() const { return stage_ == Stage::done; }

  /// [L11; L21] of the front that is done, column-major.
  const double* factor() const { return front_.data(); }
  /// [L11⁻¹; −L21 L11⁻¹] of the front that is done, column-major.
  const double* inverse() const { return inverse_.data(); }

  /// Adds to a list the updates that no front has taken in: those of kept unknowns (lower triangle, by position).
  void listRemaining(std::vector<Eigen::Triplet<double, Index>>& entries) const;

  /// The work on a front, in the units of `slices.h`.
  static double workOf(Index columns, Index height);

 private:
  enum class Stage { gather, factor, update, invert, done };

  double gather();
  bool factorBlock(double& work);
  double updateColumns(double work);
  double invertBlock();
  void enter(Stage stage);
  void takeUpdate(Index child, const double* update);
  Index updateSize(Index s) const { return supernodes_->height(s) - supernodes_->columns(s); }

  const Supernodes* supernodes_ = nullptr;
  std::vector<double> front_;    // column-major panel of the current supernode
  std::vector<double> inverse_;  // the same size
  std::vector<double> scratch_;  // columns × columns
  std::vector<double> stack_;    // update matrices, column-major, lower part
  std::size_t top_ = 0;
  std::size_t bottom_ = 0;      // of the updates on the stack that the open front has not taken in
  std::vector<Index> waiting_;  // supernodes whose updates are on the stack
  std::vector<Index> placeOf_;  // #unknowns: row in the current front

  Index s_ = 0, columns_ = 0, height_ = 0, size_ = 0;  // the open front; the size of its update
  double* update_ = nullptr;
  Stage stage_ = Stage::done;
  Index at_ = 0;  // column that the stage has got to
};

}  // namespace whittle
