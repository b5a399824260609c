#pragma once

#include <optional>
#include <vector>

#include "geometry/box_tree.h"
#include "geometry/feature_edges.h"
#include "mesh/edges.h"

namespace whittle {

/// A surface as patches between creases, and how to come back to one of them. A patch is what hangs together across
/// edges that are no creases.
class PatchSurface {
 public:
  /// @param mesh to be kept by the caller
  /// @param isCrease #E
  /// @param edge length of edges where nothing curves
  PatchSurface(const TriangleMesh& mesh, const MeshEdges& edges, const std::vector<FacePair>& pairs,
               const std::vector<bool>& isCrease, double edge);

  /// Grows a part of the tree; returns whether all is there.
  bool growNext(std::size_t work) { return tree_->buildNext(work); }

  Index patchOf(Index face) const { return patchOf_[face]; }
  /// Length of edges on a face: shorter where the surface curves across it.
  double sizeAt(Index face) const { return sizes_[face]; }

  struct Foot {
    Index face;
    Vec3 point;
  };
  /// The point of a patch that is nearest to another, on a face that looks its way.
  /// @param near a face of the patch from which to begin
  Foot project(const Vec3& point, const Vec3& normal, Index near) const;

 private:
  struct Plane {
    Vec3 normal = Vec3::Zero(), point = Vec3::Zero();
    bool isFlat = false;
  };

  void joinPatches(const std::vector<FacePair>& pairs, const std::vector<bool>& isCrease);
  void findPlanes();
  Vec3 corner(Index face, int k) const { return mesh_.positions.row(mesh_.triangles(face, k)).transpose(); }

  const TriangleMesh& mesh_;
  Points normals_;
  std::vector<Index> patchOf_;
  std::vector<Plane> planes_;  // of each patch
  std::vector<double> sizes_;
  std::optional<BoxTree> tree_;
};

/// Length of edges on each face, #F, where it is to be `edge` on what is flat: a quarter of the radius by which the
/// surface bends away from a face across edges that are no creases, up to half of it where the radius is small, but not
/// finer than a tenth of `edge`.
std::vector<double> edgeSizes(const TriangleMesh& mesh, const MeshEdges& edges, const std::vector<FacePair>& pairs,
                              const std::vector<bool>& isCrease, double edge);

}  // namespace whittle
