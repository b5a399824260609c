#pragma once

#include <array>
#include <vector>

#include "mesh/triangle_mesh.h"

namespace whittle::testing {

/// Shapes as CAD programs tessellate them: few points, long slivers.

/// A plate of `holes` squares of side 0.2 in a row and as high as `height`, each drilled with a hole of a radius and so
/// many segments; the squares' corners are joined to the rims by fans.
TriangleMesh drilledPlate(int holes, double radius, int segments, double height);

/// An L of two arms of length 1, `thick` and 0.4 wide, with a fillet of a radius and so many segments in its inner
/// corner: one strip of long faces along it. The two ends of the extrusion are fans around the outer corner.
TriangleMesh filletedBracket(double thick, double radius, int segments);

/// A mug: a body of revolution of so many segments with a round lip, and a handle of another part that reaches into it.
TriangleMesh mug(int segments);

/// A body of revolution about z of a profile (radius, height) that begins and ends on the axis or is closed.
TriangleMesh revolved(const std::vector<std::array<double, 2>>& profile, int segments, bool isClosed);

}  // namespace whittle::testing
