#include "methods/local_global/edges/stiff_edges.h"

namespace whittle {

void StiffEdges::add(Index a, Index b, double weight) {
  const Index from = place(a), to = place(b);
  rings_[from].push_back({to, weight});
  rings_[to].push_back({from, weight});
}

Index StiffEdges::place(Index vertex) {
  if (placeOf_[vertex] < 0) {
    placeOf_[vertex] = static_cast<Index>(vertices_.size());
    vertices_.push_back(vertex);
    rings_.emplace_back();
  }
  return placeOf_[vertex];
}

double StiffEdges::addForces(const Points& exact, LaneRows& residual) const {
  double energy = 0;
  for (std::size_t k = 0; k < vertices_.size(); ++k) {
    Eigen::RowVector3d force = Eigen::RowVector3d::Zero();
    for (const Spoke& spoke : rings_[k]) {
      const Eigen::RowVector3d u = exact.row(spoke.to) - exact.row(k);
      force += spoke.weight * u;
      energy += spoke.weight * u.squaredNorm();
    }
    LaneRow& row = residual[vertices_[k]];
    store(&row, load(&row) +
                    Lanes{static_cast<float>(force[0]), static_cast<float>(force[1]), static_cast<float>(force[2]), 0});
  }
  return energy / 2;  // each edge was seen from both of its ends
}

}  // namespace whittle
