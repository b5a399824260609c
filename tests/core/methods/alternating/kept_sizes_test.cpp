#include "methods/alternating/kept_sizes.h"

#include <doctest/doctest.h>

#include "support/round_shapes.h"
#include "support/shapes.h"

using namespace whittle;
using namespace whittle::testing;

TEST_CASE("a part is told of by its radius, whatever becomes of its length and where it goes") {
  const RestSurface surface = measureSurface(tube(24, 6, 0.2, 1, true));
  CylinderPatch patch{{}, Vec3::UnitZ(), Vec3::Zero(), 0.2};
  for (Index f = 0; f < surface.faceCount(); ++f) patch.faces.push_back(f);
  const auto scaled = [&](double across, double along) -> Points {
    Points positions = surface.mesh.positions;
    positions.leftCols<2>() *= across;
    positions.col(2) *= along;
    return (positions.rowwise() + Eigen::RowVector3d(0.3, 0, 1)) * someRotation().transpose();
  };
  CHECK(findChangedSizes(surface, {patch}, {true}, scaled(1, 1.6)).changed == 0);
  CHECK(findChangedSizes(surface, {patch}, {true}, scaled(1.02, 0.5)).changed == 0);
  for (const double ratio : {0.9, 1.2}) {
    const SizeReport report = findChangedSizes(surface, {patch, patch}, {true, true}, scaled(ratio, 1));
    CHECK(report.changed == 2);
    CHECK(report.most == doctest::Approx(ratio).epsilon(1e-9));
    CHECK(findChangedSizes(surface, {patch}, {false}, scaled(ratio, 1)).changed == 0);
  }
}
