#include "linear/ordering.h"

#include "linear/minimum_degree.h"
#include "linear/nested_dissection.h"

namespace whittle {

namespace {

/// Unknowns below which minimum degree is about as good and several times as fast (at 22 000: as little fill in a tenth of the time;
/// at 41 000, 28 % more).
constexpr std::int64_t kDissectFrom = 25000;

}  // namespace

std::vector<Index> eliminationOrder(const Graph& graph, const Points* coordinates, Index blockSize) {
  const bool large = static_cast<std::int64_t>(blockSize) * graph.size() >= kDissectFrom;
  const bool inSpace = coordinates && coordinates->rows() == graph.size();
  return large && inSpace ? nestedDissectionOrder(graph, *coordinates) : minimumDegreeOrder(graph);
}

}  // namespace whittle
