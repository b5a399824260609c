#include "geometry/cotangent.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

#include "base/tiering.h"

namespace whittle {

namespace {

/// Twice the area is at least this share of the longest edge squared. The numerators alone form a semidefinite matrix,
/// so any positive floor keeps L semidefinite; this one keeps its condition within reach of double precision.
constexpr double kAreaFloor = 1e-8;

/// Sums what the faces add to each edge. Terms are gathered by rows; rows come in order, so that when each hands its
/// sums out to the columns, these are sorted.
class LaplacianAssembly {
 public:
  LaplacianAssembly(const Triangles& triangles, const CornerScalars& halfCotangents, Index vertexCount)
      : triangles_(triangles), halfCotangents_(halfCotangents), vertexCount_(vertexCount), diagonal_(vertexCount, 0),
        rowStart_(vertexCount + 1, 0), seenAt_(vertexCount, -1), L_(vertexCount, vertexCount) {}

  SparseMatrix assemble();

 private:
  struct Term {
    Index column;
    double value;
  };

  /// Calls `visit` with the row, the column and the half cotangent of the edge opposite to each corner.
  template <typename Visit>
  void forEachEdge(Visit visit) const;
  void gatherTerms();
  Index sumRow(Index begin, Index end, Index kept);
  void handOut();

  const Triangles& triangles_;
  const CornerScalars& halfCotangents_;
  const Index vertexCount_;
  std::vector<Term> terms_;  // by rows, then summed
  std::vector<double> diagonal_;
  std::vector<Index> rowStart_;  // #V + 1, in `terms_`
  std::vector<Index> seenAt_;    // where a column last had a term
  SparseMatrix L_;
};

template <typename Visit>
void LaplacianAssembly::forEachEdge(Visit visit) const {
  for (Index f = 0; f < triangles_.rows(); ++f) {
    for (int k = 0; k < 3; ++k) {
      const auto [column, row] = std::minmax(triangles_(f, (k + 1) % 3), triangles_(f, (k + 2) % 3));
      if (row != column) visit(row, column, halfCotangents_(f, k));
    }
  }
}

SparseMatrix LaplacianAssembly::assemble() {
  gatherTerms();
  Index kept = 0;
  for (Index row = 0, begin = 0; row < vertexCount_; ++row) {
    const Index end = rowStart_[row + 1];
    kept = sumRow(begin, end, kept);
    rowStart_[row + 1] = kept;
    begin = end;
  }
  terms_.resize(kept);
  handOut();
  return std::move(L_);
}

void LaplacianAssembly::gatherTerms() {
  std::vector<Index> next(vertexCount_ + 2, 0);  // two ahead, so that filling them in leaves the ends
  forEachEdge([&](Index row, Index, double) { ++next[row + 2]; });
  std::partial_sum(next.begin(), next.end(), next.begin());
  terms_.resize(next.back());
  forEachEdge([&](Index row, Index column, double c) {
    terms_[next[row + 1]++] = {column, -c};
    diagonal_[column] += c;
    diagonal_[row] += c;
  });
  std::copy(next.begin(), next.end() - 1, rowStart_.begin());
}

/// Adds up the terms of the same column and moves the sums to the front.
WHITTLE_OWN_FUNCTION Index LaplacianAssembly::sumRow(Index begin, Index end, Index kept) {
  const Index first = kept;
  for (Index t = begin; t < end; ++t) {
    const Term term = terms_[t];
    Index& place = seenAt_[term.column];
    if (place >= first) {
      terms_[place].value += term.value;
    } else {
      place = kept;
      terms_[kept++] = term;
    }
  }
  return kept;
}

void LaplacianAssembly::handOut() {
  Index* const start = L_.outerIndexPtr();
  for (Index column = 0; column < vertexCount_; ++column) start[column + 1] = 1;
  for (const Term& term : terms_) ++start[term.column + 1];
  std::partial_sum(start, start + vertexCount_ + 1, start);
  L_.resizeNonZeros(start[vertexCount_]);
  std::vector<Index> next(start, start + vertexCount_);
  const auto put = [&](Index row, Index column, double value) {
    const Index place = next[column]++;
    L_.innerIndexPtr()[place] = row;
    L_.valuePtr()[place] = value;
  };
  for (Index row = 0; row < vertexCount_; ++row) {
    put(row, row, diagonal_[row]);
    for (Index t = rowStart_[row]; t < rowStart_[row + 1]; ++t) put(row, terms_[t].column, terms_[t].value);
  }
}

}  // namespace

CornerScalars halfCotangents(const Points& positions, const Triangles& triangles) {
  CornerScalars cotangents(triangles.rows(), 3);
  halfCotangents(positions, triangles, cotangents);
  return cotangents;
}

void halfCotangents(const Points& positions, const Triangles& triangles, CornerScalars& cotangents) {
  for (Index f = 0; f < triangles.rows(); ++f) {
    Vec3 edge[3];  // edge[k] is opposite to corner k
    double longest = 0;
    double shortest = std::numeric_limits<double>::infinity();
    for (int k = 0; k < 3; ++k) {
      const Index from = triangles(f, (k + 1) % 3);
      const Index to = triangles(f, (k + 2) % 3);
      edge[k] = (positions.row(to) - positions.row(from)).transpose();
      longest = std::max(longest, edge[k].squaredNorm());
      shortest = std::min(shortest, edge[k].squaredNorm());
    }
    if (shortest == 0) {
      cotangents.row(f).setZero();
      continue;
    }
    const double doubledArea = std::max(edge[0].cross(edge[1]).norm(), kAreaFloor * longest);
    for (int k = 0; k < 3; ++k) {
      cotangents(f, k) = -0.5 * edge[(k + 1) % 3].dot(edge[(k + 2) % 3]) / doubledArea;
    }
  }
}

SparseMatrix cotangentLaplacian(const Triangles& triangles, const CornerScalars& halfCotangents, Index vertexCount) {
  return LaplacianAssembly(triangles, halfCotangents, vertexCount).assemble();
}

LaplacianPattern::LaplacianPattern(const Triangles& triangles, Index vertexCount, const std::vector<Index>& held)
    : triangles_(triangles), isHeld_(vertexCount, false), edgePlaces_(triangles.rows(), 3) {
  for (const Index v : held) isHeld_[v] = true;
  lower_ = cotangentLaplacian(triangles, CornerScalars::Ones(triangles.rows(), 3), vertexCount);
  for (Index f = 0; f < triangles.rows(); ++f) {
    for (int k = 0; k < 3; ++k) {
      const auto [column, row] = std::minmax(triangles(f, (k + 1) % 3), triangles(f, (k + 2) % 3));
      const Index* begin = lower_.innerIndexPtr() + lower_.outerIndexPtr()[column];
      const Index* end = lower_.innerIndexPtr() + lower_.outerIndexPtr()[column + 1];
      const bool isFree = row != column && !isHeld_[row] && !isHeld_[column];
      edgePlaces_(f, k) =
          isFree ? static_cast<Index>(std::lower_bound(begin, end, row) - lower_.innerIndexPtr()) : kNowhere;
    }
  }
}

const SparseMatrix& LaplacianPattern::fill(const CornerScalars& halfCotangents) {
  double* values = lower_.valuePtr();
  const Index* diagonal = lower_.outerIndexPtr();  // sorted columns of a lower triangle begin with it
  std::fill_n(values, lower_.nonZeros(), 0.0);
  for (Index f = 0; f < triangles_.rows(); ++f) {
    for (int k = 0; k < 3; ++k) {
      const Index i = triangles_(f, (k + 1) % 3), j = triangles_(f, (k + 2) % 3);
      if (i == j) continue;
      const double c = halfCotangents(f, k);
      if (edgePlaces_(f, k) != kNowhere) values[edgePlaces_(f, k)] -= c;
      values[diagonal[i]] += c;
      values[diagonal[j]] += c;
    }
  }
  for (Index v = 0; v < lower_.cols(); ++v) {
    if (isHeld_[v]) values[diagonal[v]] = 1;
  }
  return lower_;
}

}  // namespace whittle
