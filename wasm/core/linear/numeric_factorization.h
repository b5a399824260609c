#pragma once

#include <vector>

#include "base/status.h"
#include "linear/entry_places.h"
#include "linear/multifrontal.h"
#include "linear/packed_factor.h"

namespace whittle {

/// The numeric half of a factorization, in slices: supernode after supernode from the entries of A to the packed
/// factor.
class NumericFactorization {
 public:
  /// @param supernodes to be kept by the caller, like the entries and the factor
  NumericFactorization(const Supernodes& supernodes, const EntryPlaces& entries, PackedFactor& factor)
      : supernodes_(supernodes), entries_(entries), factor_(factor) {}

  /// Measures the memory and the work that a new pattern needs.
  void measure();

  /// @param A to be kept by the caller until the factorization is done
  /// @param keepWorkspace whether the working memory stays for the next one
  void begin(const SparseMatrix& A, bool keepWorkspace);

  /// Does a slice.
  /// @param share out: of the work that is done
  Status next(double& share, double work);

  /// What elimination has left in the kept unknowns: S = A_kk − A_ke A_ee⁻¹ A_ek, the lower triangle, numbered from 0.
  SparseMatrix takeSchurComplement() { return std::move(schur_); }

 private:
  void open();
  bool close();
  void formSchurComplement();

  const Supernodes& supernodes_;
  const EntryPlaces& entries_;
  PackedFactor& factor_;
  std::size_t peakUpdates_ = 0;  // largest stack of update matrices, in numbers
  double allWork_ = 0;
  std::vector<double> diagonal_;  // of A, for the supernode that is being factored
  Multifrontal fronts_;

  const SparseMatrix* A_ = nullptr;
  bool keepWorkspace_ = false;
  bool isClaimed_ = false;  // the working memory
  bool isOpen_ = false;     // the front of the supernode
  Index supernode_ = 0;
  double doneWork_ = 0;
  SparseMatrix schur_;
};

}  // namespace whittle
