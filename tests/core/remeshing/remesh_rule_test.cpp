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

TEST_CASE("edges are a third of the smallest radius, within limits") {
  CHECK(remeshedEdge(drilledPlate(5, .08, 48, .06)) == doctest::Approx(.08 / 3).epsilon(.05));
  CHECK(remeshedEdge(drilledPlate(5, .03, 48, .06)) == doctest::Approx(.02));
  CHECK(remeshedEdge(longBox(1, 1)) == doctest::Approx(.04));
  TriangleMesh large = drilledPlate(5, .08, 48, .06);
  large.positions *= 70;
  CHECK(remeshedEdge(large) == doctest::Approx(70 * .08 / 3).epsilon(.05));
}
