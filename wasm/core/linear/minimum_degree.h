#pragma once

#include <vector>

#include "linear/graph.h"

namespace whittle {

/// Elimination order by approximate minimum degree (Amestoy, Davis and Duff 1996): position → node. Keeps the factor of matrices on
/// this graph sparse. Nodes of very many neighbours, more than ten times √#nodes, go last.
std::vector<Index> minimumDegreeOrder(const Graph& graph);

}  // namespace whittle
