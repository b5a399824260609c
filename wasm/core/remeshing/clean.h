#pragma once

#include <vector>

#include "remeshing/derived_mesh.h"

namespace whittle {

/// A face thinner than this, height over longest side, has no normal that means anything.
inline constexpr double kSliver = 1e-3;

/// A mesh without faces that no method can work on.
struct CleanMesh {
  DerivedMesh derived;          // the mesh itself where there was nothing to mend
  Index mended = 0;             // faces that were collapsed, cut away or dropped
  std::vector<Index> unmended;  // faces of the derived mesh that are slivers still: nothing could be done without harm
};

/// Takes away doubled faces, faces that use a vertex twice, and slivers: the short side of a needle is collapsed, a cap
/// is cut away by putting the vertex on its long side into the faces beyond. Creases, borders and edges of three and
/// more faces stay within the height of what is cut away, nothing is merged across a thin wall, and what lies in one
/// place without being connected stays apart. Faces without area that cannot be mended are dropped.
CleanMesh clean(const TriangleMesh& mesh);

}  // namespace whittle
