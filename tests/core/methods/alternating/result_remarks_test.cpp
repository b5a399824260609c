#include "methods/alternating/result_remarks.h"

#include <doctest/doctest.h>

#include "support/round_shapes.h"

using namespace whittle;
using namespace whittle::testing;

TEST_CASE("what a result did to a shape is told in sentences, and nothing where it did nothing") {
  const RestSurface rest = measureSurface(tube(24, 6, 0.05, 1, true));
  Structure structure;
  structure.patches = {{{}, Vec3::UnitZ(), Vec3::Zero(), 0.05}};
  for (Index f = 0; f < rest.faceCount(); ++f) structure.patches[0].faces.push_back(f);
  ThinWallSearch walls(rest);
  while (walls.next() < 1) {
  }
  structure.walls = walls.take();
  Points wider = rest.mesh.positions;
  wider.leftCols<2>() *= 1.5;
  const std::vector<bool> kept{true};
  const std::vector<PointRow> handles;

  CHECK(resultRemarks({rest, structure, kept, handles, rest.mesh.positions, {}, 0, true}).empty());
  CHECK(resultRemarks({rest, structure, kept, handles, wider, {}, 0, false}).empty());
  FoldReport folds;
  folds.flipped = 7;
  CHECK(resultRemarks({rest, structure, kept, handles, wider, folds, 0.012, true}) ==
        std::vector<std::string>{
            "Of the faces 7 fold over; a smaller move, or more handles, may help.",
            "Of the holes, round parts and bevels 1 changes its size by this gesture; the farthest is 1.50 times what "
            "it was.",
            "Walls and thin parts become up to 1.50 times as thick by this gesture.",
            "A handle is missed by 1.2 % of the diagonal: what the handles ask for does not go together with the "
            "shape."});
}
