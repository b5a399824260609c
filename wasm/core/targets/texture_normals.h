#pragma once

#include "base/status.h"
#include "mesh/triangle_mesh.h"

namespace whittle {

/// Two numbers per face corner, three rows a face (3·#F×2).
using CornerPairs = Eigen::Matrix<float, Eigen::Dynamic, 2, Eigen::RowMajor>;

/// A texture that says how a surface rises and falls: its slopes where the corners of the faces lie in it.
struct TextureSlopes {
  CornerPairs uvs;     // u to the right, v upward; NaN at corners that have none
  CornerPairs slopes;  // rise along u and along v, of a normal (x, y, z) in the texture’s own frame −x/z and −y/z
};

bool operator==(const TextureSlopes& a, const TextureSlopes& b);

/// Fails with `badParameter` where counts do not fit or a slope is not finite, with `unsuitableMesh` if no face has
/// texture coordinates that span an area.
Status validateTextureSlopes(const TextureSlopes& texture, Index faceCount);

/// The unit normals (#V×3) that vertices have once the texture, `strength` times as steep, stands on the surface: the
/// mean over the faces around, weighted by area. At a corner the texture’s frame is u along the surface, made
/// perpendicular to the vertex normal, and v across it to the side where v grows: mirrored texture coordinates stay
/// mirrored, and a seam has the mean of both sides.
/// @param normals unit or zero, #V×3; where the texture is flat or the faces have no frame they are the answer, to the
///   bit
Points raisedVertexNormals(const TriangleMesh& mesh, const Points& normals, const TextureSlopes& texture,
                           double strength);

/// Unit normals (#F×3) of faces, in the frame of each alone, from the mean slope of its corners.
/// @param normals unit or zero, #F×3
Points raisedFaceNormals(const TriangleMesh& mesh, const Points& normals, const TextureSlopes& texture,
                         double strength);

}  // namespace whittle
