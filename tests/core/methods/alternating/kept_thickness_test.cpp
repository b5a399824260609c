#include "methods/alternating/kept_thickness.h"

#include <doctest/doctest.h>

#include "support/round_shapes.h"
#include "support/shapes.h"

using namespace whittle;
using namespace whittle::testing;

namespace {

struct Thin {
  RestSurface surface;
  std::vector<ThicknessProbe> probes;

  explicit Thin(const TriangleMesh& mesh) : surface(measureSurface(mesh)) {
    ThinWallSearch search(surface);
    while (search.next() < 1) {
    }
    probes = search.take().probes;
  }

  ThicknessReport report(const Vec3& scale, const std::vector<PointRow>& handles = {}) const {
    return findChangedThickness(surface, probes, handles,
                                surface.mesh.positions * scale.asDiagonal() * someRotation().transpose());
  }
};

/// A bar along z, 16 facets round.
const Thin& bar() {
  static const Thin bar(cylinder(16, 12, 2, 0.05, 1, false));
  return bar;
}

}  // namespace

TEST_CASE("thickness is told of where it changes, whatever becomes of length") {
  CHECK(bar().probes.size() > 100);
  CHECK(bar().report({1, 1, 1.7}).changedArea == 0);
  CHECK(bar().report({1.05, 1.05, 1}).changedArea == 0);
  for (const double ratio : {0.7, 1.5}) {
    const ThicknessReport report = bar().report({ratio, ratio, 1});
    CHECK(report.changedArea == doctest::Approx(1));
    CHECK(report.most == doctest::Approx(ratio));
  }
}

TEST_CASE("a shape that is nowhere thin has no thickness to tell of") {
  const Thin ball(sphere(3));
  CHECK(ball.probes.empty());
  CHECK(ball.report({2, 2, 2}).changedArea == 0);
}

TEST_CASE("thickness that handles ask for on both sides is not told of") {
  std::vector<PointRow> handles(bar().surface.vertexCount());
  for (Index v = 0; v < bar().surface.vertexCount(); ++v) {
    const Vec3 p = bar().surface.mesh.positions.row(v).transpose();
    handles[v].add(v, 1);
    handles[v].target = Vec3(1.5, 1.5, 1).cwiseProduct(p);
  }
  CHECK(bar().report({1.5, 1.5, 1}, handles).changedArea == 0);
  for (PointRow& handle : handles) handle.target.head<2>() /= 1.5;
  CHECK(bar().report({1.5, 1.5, 1}, handles).changedArea == doctest::Approx(1));
}
