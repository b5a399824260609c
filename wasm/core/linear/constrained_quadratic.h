#pragma once

#include <memory>
#include <vector>

#include "linear/row_planes.h"
#include "linear/sparse_cholesky.h"
#include "simd/lanes.h"

namespace whittle {

class PlaneSystem;

/// Minimises ½ tr(Xᵀ A X) − tr(Bᵀ X) over X (#n×3) with some rows of X held where they are and others on planes. Works
/// on corrections, so the single precision of the factor costs nothing in the end: the error of each solve is relative
/// to the step that it takes.
///
/// Held rows are eliminated. Planes couple the three columns of X, but only in the rows that are on them, and these are
/// ordered last: all other rows are factored once for the three columns as ever, and what that leaves in the rows on
/// planes is a system of its own, in their free coordinates. So planes of any normals cost little. As multiples of a
/// correction without them, for 65,000 rows as wasm: 1.2 to 1.5 with 500 rows scattered over the mesh or a patch of
/// 5,000, 2 with 1,000 scattered or a patch of 20,000; preparing takes twice as long with 500 scattered. Scattered rows
/// leave a dense system, so a few thousand that are each alone are the worst case. Dropped without a trial: a factor for
/// each coordinate (three times the memory, and only for planes across axes), one system of 3n unknowns (nine times the
/// memory), Lagrange multipliers (two solves a correction, and one more in advance for every three planes).
class ConstrainedQuadratic {
 public:
  ConstrainedQuadratic();
  ~ConstrainedQuadratic();
  ConstrainedQuadratic(ConstrainedQuadratic&&) noexcept;
  ConstrainedQuadratic& operator=(ConstrainedQuadratic&&) noexcept;

  /// Factors A (#n×#n, symmetric, positive definite for what is not held; only the lower triangle is read). It is taken
  /// over and let go before the factorization, whose memory is the peak.
  /// @param held rows that stay where they are, whatever planes they are on; may hold an index twice
  /// @param ordering of all rows of A, held ones too, in blocks of 1
  /// @param planes may hold several of a row: two hold it on a line, three in a point
  /// @returns `badPlanes` and the row if its planes exclude each other (see `joinPlanes`), `numericalFailure` if what
  ///   is not held is not definite
  Status prepare(SparseMatrix A, const std::vector<Index>& held, const Ordering& ordering = {},
                 const std::vector<RowPlane>& planes = {});

  /// Begins to prepare; `prepareNext` does it slice by slice (`slices.h`). Coordinates are kept by the caller until
  /// then.
  void beginPrepare(SparseMatrix A, std::vector<Index> held, const Ordering& ordering = {},
                    std::vector<RowPlane> planes = {});
  /// Does a slice.
  /// @param share out: the share of the work that is done; 1 after a failure, too
  Status prepareNext(double& share, double work = kSliceWork);

  /// Makes of residuals B − A X at some X the corrections ΔX that lead from there to the minimum: zero in held rows,
  /// along their planes in those on planes. Allocates nothing. A residual across a slanted plane, the force that holds
  /// the row there, is rounded together with what is along it: there the minimum is met to about 1e-7 of that force.
  /// @param residual rows of X filled up to whole batches, and one more that nobody reads (`paddedRows`)
  /// Planes are met to single precision then, and `satisfyPlanes` takes off what that has left.
  void correct(LaneRows& residual);
  static std::size_t paddedRows(Index n) { return 4 * batchCount(n) + 1; }

 private:
  struct Preparation;

  Status begin();

  std::vector<Index> held_;
  bool allHeld_ = false;
  SparseCholesky cholesky_;
  std::unique_ptr<PlaneSystem> planeSystem_;  // where rows on planes have freedom left
  std::unique_ptr<Preparation> preparation_;  // while it goes on
};

}  // namespace whittle
