#pragma once

#include <vector>

#include "geometry/feature_edges.h"
#include "mesh/triangle_mesh.h"
#include "methods/alternating/cylinder_patches.h"

namespace whittle {

/// The bevels of a mesh, by their first faces: flat strips between two creases that bend the same way, by 20° to 70°, at
/// least twice as long as wide, between flat faces twice as wide and more. (The sides of a rod are no bevels: those
/// beside them are as wide.) Each is a patch with its own direction as the axis and its width as the radius, for what
/// is to become of it is what is to become of a fillet in its place.
/// @param mesh in any frame
std::vector<CylinderPatch> bevels(const TriangleMesh& mesh, const std::vector<FacePair>& pairs);

}  // namespace whittle
