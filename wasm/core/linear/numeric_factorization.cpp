#include "linear/numeric_factorization.h"

#include <algorithm>
#include <limits>

namespace whittle {

namespace {

/// Pivots that cancellation has eaten (rounding leaves some multiples of ε) say only that the matrix is singular to
/// working precision; those out of range would overflow in single precision.
bool arePivotsSound(const double* factor, Index stride, const double* diagonal, Index columns) {
  constexpr double kNoise = 64 * std::numeric_limits<double>::epsilon();
  for (Index j = 0; j < columns; ++j) {
    const double pivot = factor[static_cast<std::ptrdiff_t>(j) * stride];  // its square root
    if (!(pivot * pivot > kNoise * diagonal[j] && pivot > 1e-30 && pivot < 1e30)) return false;
  }
  return true;
}

}  // namespace

void NumericFactorization::measure() {
  peakUpdates_ = 0;
  allWork_ = 0;
  std::size_t stack = 0;
  std::vector<std::size_t> ofChildren(supernodes_.count(), 0);
  Index mostColumns = 0;
  for (Index s = 0; s < supernodes_.count(); ++s) {
    const std::size_t size = supernodes_.height(s) - supernodes_.columns(s), update = size * size;
    peakUpdates_ = std::max(peakUpdates_, stack + update);
    stack += update - ofChildren[s];
    if (supernodes_.parent[s] >= 0) ofChildren[supernodes_.parent[s]] += update;
    mostColumns = std::max(mostColumns, supernodes_.columns(s));
    allWork_ += Multifrontal::workOf(supernodes_.columns(s), supernodes_.height(s));
  }
  diagonal_.resize(mostColumns);
}

void NumericFactorization::begin(const SparseMatrix& A, bool keepWorkspace) {
  A_ = &A;
  keepWorkspace_ = keepWorkspace;
  isClaimed_ = isOpen_ = false;
  supernode_ = 0;
  doneWork_ = 0;
}

Status NumericFactorization::next(double& share, double work) {
  if (!isClaimed_) {  // a slice of its own: the system clears so much memory no faster than it is worked on
    isClaimed_ = true;
    fronts_.begin(supernodes_, peakUpdates_);
    share = 0;
    return {};
  }
  const double given = work;
  bool definite = true;
  while (definite && supernode_ < supernodes_.count() && work > 0) {
    if (!isOpen_) open();
    definite = fronts_.advance(work) && (!fronts_.isDone() || close());
  }
  doneWork_ += given - work;
  const bool ended = !definite || supernode_ == supernodes_.count();
  share = ended ? 1 : std::min(0.999, doneWork_ / allWork_);
  if (ended && definite) formSchurComplement();
  if (ended && !keepWorkspace_) fronts_ = {};
  if (definite) return {};
  return Status::failure(
      Code::numericalFailure,
      "the linear system is not positive definite; the mesh may hold faces too thin to compute with");
}

void NumericFactorization::formSchurComplement() {
  const Index n = static_cast<Index>(A_->cols()), first = supernodes_.columnStart.back();
  if (first == n) return;
  std::vector<Eigen::Triplet<double, Index>> entries;
  fronts_.listRemaining(entries);
  for (auto& entry : entries) entry = {entry.row() - first, entry.col() - first, entry.value()};
  for (Index column = first; column < n; ++column) {
    for (SparseMatrix::InnerIterator entry(*A_, column); entry; ++entry) {
      if (entry.row() >= column) entries.emplace_back(entry.row() - first, column - first, entry.value());
    }
  }
  schur_.resize(n - first, n - first);
  schur_.setFromTriplets(entries.begin(), entries.end());
}

void NumericFactorization::open() {
  isOpen_ = true;
  double* front = fronts_.open(supernode_);
  entries_.add(A_->valuePtr(), supernode_, front);
  const std::ptrdiff_t stride = supernodes_.height(supernode_) + 1;
  for (Index j = 0; j < supernodes_.columns(supernode_); ++j) diagonal_[j] = front[j * stride];
}

/// Returns false if the pivots are not sound.
bool NumericFactorization::close() {
  const Index columns = supernodes_.columns(supernode_), stride = supernodes_.height(supernode_) + 1;
  if (!arePivotsSound(fronts_.factor(), stride, diagonal_.data(), columns)) return false;
  factor_.pack(supernode_, fronts_.inverse());
  ++supernode_;
  isOpen_ = false;
  return true;
}

}  // namespace whittle
