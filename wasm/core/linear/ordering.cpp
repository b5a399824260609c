#include "linear/ordering.h"

#include "linear/minimum_degree.h"
#include "linear/nested_dissection.h"

namespace whittle {

namespace {

/// Unknowns below which minimum degree is about as good and several times as fast (at 22 000: as little fill in a tenth
/// of the time; at 41 000, 28 % more).
constexpr std::int64_t kDissectFrom = 25000;

}  // namespace

EliminationOrdering::EliminationOrdering(const Graph& graph, const Points* coordinates, Index blockSize) {
  const bool large = static_cast<std::int64_t>(blockSize) * graph.size() >= kDissectFrom;
  const bool inSpace = coordinates && coordinates->rows() == graph.size();
  if (large && inSpace) {
    dissection_ = std::make_unique<NestedDissection>(graph, *coordinates);
  } else {
    degrees_ = std::make_unique<MinimumDegree>(graph);
  }
}

EliminationOrdering::~EliminationOrdering() = default;
EliminationOrdering::EliminationOrdering(EliminationOrdering&&) noexcept = default;
EliminationOrdering& EliminationOrdering::operator=(EliminationOrdering&&) noexcept = default;

double EliminationOrdering::next(double work) { return dissection_ ? dissection_->next(work) : degrees_->next(work); }

std::vector<Index> EliminationOrdering::take() { return dissection_ ? dissection_->take() : degrees_->take(); }

std::vector<Index> eliminationOrder(const Graph& graph, const Points* coordinates, Index blockSize) {
  EliminationOrdering ordering(graph, coordinates, blockSize);
  while (ordering.next() < 1) {
  }
  return ordering.take();
}

}  // namespace whittle
