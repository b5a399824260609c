#include "methods/spherical/midpoint_refinement.h"

#include <algorithm>
#include <map>

namespace whittle {

MidpointRefinement::MidpointRefinement(const TriangleMesh& coarse, Index leastVertices)
    : mesh_(coarse), coarseCount_(coarse.vertexCount()) {
  while (coarseCount_ + static_cast<Index>(ends_.size()) < leastVertices) halveEdges();
  mesh_.positions.resize(coarseCount_ + static_cast<Index>(ends_.size()), 3);
  spread(coarse.positions, mesh_.positions);
}

void MidpointRefinement::spread(const Points& coarse, Points& fine) const {
  fine.topRows(coarseCount_) = coarse;
  for (std::size_t i = 0; i < ends_.size(); ++i) {
    const auto& [a, b] = ends_[i];
    fine.row(coarseCount_ + static_cast<Index>(i)) = 0.5 * (fine.row(a) + fine.row(b));
  }
}

void MidpointRefinement::halveEdges() {
  std::map<std::pair<Index, Index>, Index> middles;
  const auto middleOf = [&](Index a, Index b) {
    const std::pair<Index, Index> ends = std::minmax(a, b);
    const auto [entry, isNew] = middles.try_emplace(ends, coarseCount_ + static_cast<Index>(ends_.size()));
    if (isNew) ends_.push_back(ends);
    return entry->second;
  };
  Triangles triangles(4 * mesh_.triangles.rows(), 3);
  for (Index f = 0; f < mesh_.triangles.rows(); ++f) {
    const Index a = mesh_.triangles(f, 0), b = mesh_.triangles(f, 1), c = mesh_.triangles(f, 2);
    const Index ab = middleOf(a, b), bc = middleOf(b, c), ca = middleOf(c, a);
    triangles.middleRows<4>(4 * f) << a, ab, ca, ab, b, bc, ca, bc, c, ab, bc, ca;
  }
  mesh_.triangles = std::move(triangles);
}

}  // namespace whittle
