#pragma once

#include <memory>
#include <vector>

#include "linear/graph.h"
#include "linear/slices.h"

namespace whittle {

class MinimumDegree;
class NestedDissection;

/// How the unknowns of a matrix are to be numbered for its factorization.
struct Ordering {
  const Points* coordinates = nullptr;  // one row per node: where it is, for systems large enough to be cut in space
  Index blockSize = 1;                  // unknowns per node, numbered blockSize·node + component
  bool isOrdered = false;               // whether the nodes come in a good elimination order already
  Index kept = 0;                       // so many nodes, the last ones, are not eliminated: they are left with a system
};

/// Makes an elimination order that keeps the Cholesky factor of matrices on a graph sparse: minimum degree for
/// small systems, nested dissection for large ones with coordinates, size being counted in unknowns, `blockSize` per
/// node. It stays good when nodes are taken out, so one order serves a mesh whatever is held. The same graph gives the
/// same order everywhere.
class EliminationOrdering {
 public:
  /// @param graph to be kept by the caller until the order is there
  /// @param coordinates #nodes×3, to be kept as well; nullptr: unknown
  explicit EliminationOrdering(const Graph& graph, const Points* coordinates = nullptr, Index blockSize = 1);
  ~EliminationOrdering();
  EliminationOrdering(EliminationOrdering&&) noexcept;
  EliminationOrdering& operator=(EliminationOrdering&&) noexcept;

  /// Does a slice of it; returns the share that is done.
  double next(double work = kSliceWork);
  /// The order, position → node, once all is done.
  std::vector<Index> take();

 private:
  std::unique_ptr<MinimumDegree> degrees_;  // one of the two
  std::unique_ptr<NestedDissection> dissection_;
};

/// The order in one go.
std::vector<Index> eliminationOrder(const Graph& graph, const Points* coordinates = nullptr, Index blockSize = 1);

}  // namespace whittle
