#pragma once

#include "linear/graph.h"

namespace whittle {

/// Elimination order by nested dissection (George 1973): position → node. Each part is cut in two across the best of several
/// directions in space; the smallest set of nodes that separates the halves goes last, and small parts are ordered by
/// minimum degree. Coordinates (#nodes×3) only suggest where to cut: coincident ones or ones that have nothing to do
/// with the graph cost fill, never correctness.
std::vector<Index> nestedDissectionOrder(const Graph& graph, const Points& coordinates);

}  // namespace whittle
