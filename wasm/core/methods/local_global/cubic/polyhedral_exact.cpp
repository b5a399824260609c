#include "methods/local_global/cubic/polyhedral_exact.h"

#include "geometry/rotation_fit.h"
#include "methods/local_global/cubic/cubic_search.h"

namespace whittle {

Lanes PolyhedralExact::solve(std::size_t batch, const CubicLanes& vertices, QuaternionLanes& rotations) {
  const QuaternionLanes before = rotations;
  SubgradientLanes& u = subgradients_[batch];
  auto [regularizers, certified] =
      climbPolyhedral(vertices.M, vertices.n, vertices.weights.x, polyhedron_, u, rotations);
  if (all(certified)) return regularizers;
  for (int lane = 0; lane < 4; ++lane) {
    if (certified[lane]) continue;
    const CubicVertex cubic = vertexAt(vertices, lane);
    const PolyhedralVertex vertex(cubic.M, cubic.n, cubic.weights.x(), polyhedron_);
    const Mat3 R = vertex.weight == 0 ? fitRotation(vertex.M) : searchCubic(vertex, rotationAt(before, lane));
    setRotation(rotations, lane, R);
    const Vec3 s = R * vertex.n;
    regularizers[lane] = static_cast<float>(vertex.weight * polyhedron_.support(s));
    for (Index j = 0; j < polyhedron_.rowCount; ++j) {
      const double side = polyhedron_.rows[j].dot(s);
      u[j][lane] = std::abs(side) < 1e-6 ? 0 : std::copysign(1.0f, static_cast<float>(side));
    }
  }
  return regularizers;
}

}  // namespace whittle
