#include "geometry/box_tree.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <limits>
#include <vector>

#include "support/shapes.h"

using namespace whittle;
using namespace whittle::testing;

TEST_CASE("the box nearest to a point is found without looking at most of them") {
  Noise noise;
  std::vector<Box> boxes;
  for (int i = 0; i < 2000; ++i) {
    const Vec3 low{noise(), noise(), noise()}, size{noise(), noise(), noise()};
    boxes.emplace_back(low, low + 0.02 * (size + Vec3::Ones()));
  }
  BoxTree tree(boxes);
  while (!tree.buildNext(500)) {
  }
  int visits = 0;
  for (int i = 0; i < 200; ++i) {
    const Vec3 point{1.5 * noise(), 1.5 * noise(), 1.5 * noise()};
    double nearest = std::numeric_limits<double>::infinity();
    for (const Box& box : boxes) nearest = std::min(nearest, box.squaredExteriorDistance(point));
    double found = std::numeric_limits<double>::infinity();
    tree.findNear(point, found, [&](Index box) {
      ++visits;
      return found = std::min(found, boxes[box].squaredExteriorDistance(point));
    });
    CHECK(found == nearest);
    bool isVisited = false;
    tree.findNear(point, nearest, [&](Index) {
      isVisited = true;
      return nearest;
    });
    CHECK(!isVisited);
  }
  CHECK(visits < 200 * 40);
}

TEST_CASE("a tree of no boxes is near nothing") {
  const BoxTree tree({});
  bool isVisited = false;
  tree.findNear(Vec3::Zero(), std::numeric_limits<double>::infinity(), [&](Index) {
    isVisited = true;
    return 0.0;
  });
  CHECK(!isVisited);
}
