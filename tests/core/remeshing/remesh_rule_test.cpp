#include "remeshing/remesh_rule.h"

#include <doctest/doctest.h>

#include "mesh/bounding_box.h"
#include "support/cad_shapes.h"
#include "support/shapes.h"

using namespace whittle;
using namespace whittle::testing;

TEST_CASE("the rule: shapes of few long faces are remeshed, even and fine ones are not") {
  CHECK(needsRemeshing(drilledPlate(5, .05, 32, .06)) == RemeshCause::slivers);
  CHECK(needsRemeshing(mug(64)) == RemeshCause::slivers);
  CHECK(needsRemeshing(longBox(1, 1)) == RemeshCause::coarseness);
  TriangleMesh uneven = grid(60);
  uneven.positions.topRows<60>().col(1).array() -= 0.2;
  CHECK(needsRemeshing(uneven) == RemeshCause::unevenEdges);
  CHECK(needsRemeshing(bent(torus(60))) == RemeshCause::none);
}

TEST_CASE("edges are as long whatever the units, and longer where they would be too many") {
  const TriangleMesh plate = drilledPlate(5, .05, 48, .06);
  CHECK(remeshedEdge(plate) == doctest::Approx(.04));
  TriangleMesh large = plate;
  large.positions *= 70;
  CHECK(remeshedEdge(large) == doctest::Approx(70 * .04));
  // A rack of rods, all of them round.
  TriangleMesh rods = prism(24, 0);
  rods.positions *= Vec3(.01, .01, 1 / 1.5).asDiagonal();
  for (int i = 0; i < 8; ++i)
    rods = together(rods, rods, i % 2 ? Vec3(.03 * (1 << i / 2), 0, 0) : Vec3(0, .03 * (1 << i / 2), 0));
  CHECK(remeshedEdge(rods) > .05 * boundingBox(rods).sizes().maxCoeff());
}
