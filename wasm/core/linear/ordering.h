#pragma once

#include <vector>

#include "linear/graph.h"

namespace whittle {

/// How the unknowns of a matrix are to be numbered for its factorization.
struct Ordering {
  const Points* coordinates = nullptr;        // one row per node: where it is in space, for systems large enough to be cut in space
  Index blockSize = 1;                        // unknowns per node, numbered blockSize·node + component
  bool isOrdered = false;                     // whether the nodes come in a good elimination order already
};

/// An elimination order that keeps the Cholesky factor of matrices on this graph sparse: position → node. Minimum degree for
/// small systems, nested dissection for large ones with coordinates (#nodes×3; nullptr: unknown), size being counted in
/// unknowns, `blockSize` per node. It stays good when nodes are taken out, so one order serves a mesh whatever is held. The same
/// graph gives the same order everywhere.
std::vector<Index> eliminationOrder(const Graph& graph, const Points* coordinates = nullptr, Index blockSize = 1);

}  // namespace whittle
