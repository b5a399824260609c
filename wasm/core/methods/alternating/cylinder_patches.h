#pragma once

#include <vector>

#include "constraints/handles.h"
#include "geometry/curvature.h"
#include "geometry/feature_edges.h"
#include "mesh/triangle_mesh.h"

namespace whittle {

/// Faces that hang together and lie on one cylinder: a hole's wall, a rod, a fillet, full round or in part.
struct CylinderPatch {
  std::vector<Index> faces;  // ascending
  Vec3 axis;                 // unit; its sign means nothing
  Vec3 point;                // on the axis, beside the middle of the patch
  double radius;
};

/// The cylinder patches of a mesh in the unit frame, by their first faces. Faces that curve one way, by more than 1, are
/// joined across edges that are no features where they curve about nearly the same direction. Of each piece the faces
/// count whose vertices keep to one circle, within 3 % of its radius, and that look to its axis, within 20°: flat faces
/// beside a fillet, whose curvature is estimated from both, are none: they belong to something flat that is wider than any
/// facet. They are a patch if they are 8 and more, a quarter
/// of the piece and more, if their normals are at right angles to one axis (within 0.1, root mean square by area, which
/// leaves out cones, bowls and bends) and go over 30° and more, and if the radius is that of their curvature.
/// @param features #E, as the curvatures know them
std::vector<CylinderPatch> cylinderPatches(const TriangleMesh& mesh, const std::vector<FacePair>& pairs,
                                           const std::vector<bool>& features, const Curvatures& curvatures);

/// Which patches are to keep their radius, one flag each: not those that a gesture is to widen, as their own handles
/// move differently across the axis (by more than 10⁻³), nor those that are one wall with such a patch, directly or by
/// others: on the same axis (within 2°, and 5 % of the larger radius), one radius 0.7 to 1.43 times the other.
/// @param mesh at rest, in the unit frame; handles with targets in it
std::vector<bool> keptPatches(const std::vector<CylinderPatch>& patches, const TriangleMesh& mesh,
                              const Handles& handles);

}  // namespace whittle
