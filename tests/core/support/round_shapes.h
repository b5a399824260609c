#pragma once

#include <functional>

#include "mesh/triangle_mesh.h"

namespace whittle::testing {

/// How a sheet of quadrilaterals, each cut in two, lies over the unit square.
struct Weave {
  int across, along;  // quadrilaterals in u and in v
  bool closedAcross = false, closedAlong = false;
  bool staggered = false;  // every other row is half a step further in u, as in remeshed tubes
};

/// The sheet at `place(u, v)`, u and v from 0 to 1. Its sides show to ∂u × ∂v.
TriangleMesh sheet(const Weave& weave, const std::function<Vec3(double, double)>& place);

/// A tube around z from height 0, open at both ends, its triangles about equilateral where `rows` lets them.
TriangleMesh tube(int sides, int rows, double radius, double height, bool staggered);

/// A closed cylinder: a tube with discs at both ends, of `rings` rings and a middle.
TriangleMesh cylinder(int sides, int rows, int rings, double radius, double height, bool staggered);

/// Turns a mesh in a way that is nobody's special case.
TriangleMesh turned(TriangleMesh mesh);

}  // namespace whittle::testing
