#include "methods/local_global/normal_driven/developable_normals.h"

#include <algorithm>
#include <cmath>

namespace whittle {

namespace {

void add(LaneRow& row, Lanes v) { store(&row, load(&row) + v); }

/// Four matrices, one in each lane, from four rings and back.
template <typename Ring>
SymmetricLanes loadRings(const Ring* rings) {
  Lanes a = load(&rings[0].upper), b = load(&rings[1].upper), c = load(&rings[2].upper), d = load(&rings[3].upper);
  transpose(a, b, c, d);
  Lanes e = load(&rings[0].lower), f = load(&rings[1].lower), g = load(&rings[2].lower), h = load(&rings[3].lower);
  transpose(e, f, g, h);
  return {a, b, c, d, e, f};
}

template <typename Ring>
void storeRings(const SymmetricLanes& A, Ring* rings) {
  Lanes a = A.xx, b = A.xy, c = A.xz, d = A.yy;
  transpose(a, b, c, d);
  Lanes e = A.yz, f = A.zz, g = splat(0), h = splat(0);
  transpose(e, f, g, h);
  const Lanes upper[] = {a, b, c, d}, lower[] = {e, f, g, h};
  for (int lane = 0; lane < 4; ++lane) {
    store(&rings[lane].upper, upper[lane]);
    store(&rings[lane].lower, lower[lane]);
  }
}

}  // namespace

void DevelopableNormals::prepare(const TriangleMesh& rest, double creases) {
  triangles_ = &rest.triangles;
  normals_.assign(rest.faceCount(), {});
  rings_.assign(4 * batchCount(rest.vertexCount()), {});
  gatherRings(rest.positions);
  threshold_ = static_cast<float>(quantileOfBend(1 - creases));
  observe(rest.positions);
}

double DevelopableNormals::quantileOfBend(double share) const {
  std::vector<float> bends;
  for (std::size_t v = 0; v < rings_.size(); v += 4) {
    const EigenLanes eigen = eigenDecomposition(loadRings(&rings_[v]));
    for (int lane = 0; lane < 4; ++lane) {
      if (eigen.values[0][lane] > 0) bends.push_back(eigen.values[1][lane] / eigen.values[0][lane]);
    }
  }
  if (bends.empty()) return 0;
  const auto place = bends.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(bends.size() - 1));
  std::nth_element(bends.begin(), place, bends.end());
  return *place;
}

void DevelopableNormals::gatherRings(const Points& positions) {
  std::fill(rings_.begin(), rings_.end(), Ring{});
  for (Index f = 0; f < triangles_->rows(); ++f) {
    const auto corners = triangles_->row(f);
    const Vec3 first = positions.row(corners[0]).transpose();
    const Vec3 vector =
        (positions.row(corners[1]).transpose() - first).cross(positions.row(corners[2]).transpose() - first);
    const Vec3 n = vector.stableNormalized();
    setRow(normals_[f], n);
    const Vec3 weighted = 0.5 * vector;  // area n
    const Mat3 C = weighted * n.transpose();
    const Lanes upper{static_cast<float>(C(0, 0)), static_cast<float>(C(0, 1)), static_cast<float>(C(0, 2)),
                      static_cast<float>(C(1, 1))};
    const Lanes lower{static_cast<float>(C(1, 2)), static_cast<float>(C(2, 2)), 0, 0};
    for (int k = 0; k < 3; ++k) {
      add(rings_[corners[k]].upper, upper);
      add(rings_[corners[k]].lower, lower);
    }
  }
}

void DevelopableNormals::observe(const Points& positions) {
  gatherRings(positions);
  const Lanes none = splat(0);
  for (std::size_t v = 0; v < rings_.size(); v += 4) {
    const EigenLanes eigen = eigenDecomposition(loadRings(&rings_[v]));
    const LaneMask isBent = eigen.values[1] >= splat(threshold_) * eigen.values[0];
    const SymmetricLanes flat = plusOuter({none, none, none, none, none, none}, splat(1), eigen.vectors[0]);
    storeRings(plusOuter(flat, keep(isBent, splat(1)), eigen.vectors[1]), &rings_[v]);
  }
}

Vec3 DevelopableNormals::operator()(Index face) const {
  const auto corners = triangles_->row(face);
  const Ring &a = rings_[corners[0]], &b = rings_[corners[1]], &c = rings_[corners[2]];
  const Lanes upper = load(&a.upper) + load(&b.upper) + load(&c.upper),
              lower = load(&a.lower) + load(&b.lower) + load(&c.lower);
  const auto& [x, y, z, spare] = normals_[face];
  return {upper[0] * x + upper[1] * y + upper[2] * z, upper[1] * x + upper[3] * y + lower[0] * z,
          upper[2] * x + lower[0] * y + lower[1] * z};
}

}  // namespace whittle
