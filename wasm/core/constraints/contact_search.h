#pragma once

#include <optional>
#include <vector>

#include "constraints/attachments.h"
#include "geometry/box_tree.h"
#include "mesh/triangle_mesh.h"

namespace whittle {

/// How near parts must be to touch, in the unit frame: what people leave between parts that are meant to be in touch.
constexpr double kContactReach = 2e-3;

/// Finds where parts of a mesh touch or cross: every vertex within reach of another part, at the nearest point of it,
/// and every edge that goes through a face of another part. Goes slice by slice.
class ContactSearch {
 public:
  /// @param mesh in the unit frame, to be kept by the caller like its parts
  ContactSearch(const TriangleMesh& mesh, const Components& parts);

  /// Does a slice of some 10 ms; returns the share that is done, 1 at the end.
  double next();
  /// What was found, once all is done.
  std::vector<Attachment> take();

 private:
  /// An edge that goes through a face of another part.
  struct Piercing {
    Index low, high, face;
    Attachment row;
  };

  void growPartTree();
  /// Keeps a face that is near the box of another part.
  void sift(Index face);
  void compare(Index face);
  /// Attaches a vertex to the nearest point of each part that has a face in `near_`.
  void attachVertex(Index v);
  void attachEdge(Index v, Index w);
  Index partOf(Index face) const { return parts_.ofVertex[mesh_.triangles(face, 0)]; }
  Vec3 at(Index v) const { return mesh_.positions.row(v).transpose(); }
  Vec3 corner(Index face, int k) const { return at(mesh_.triangles(face, k)); }
  Box boxWithReach(Index face) const;

  const TriangleMesh& mesh_;
  const Components& parts_;
  enum class Stage { parts, sifting, tree, comparing, done } stage_ = Stage::parts;
  Index next_ = 0;                // face of this stage
  std::vector<Index> partOfBox_;  // parts that have faces
  std::optional<BoxTree> partTree_;
  std::vector<Index> faces_;  // that are near the box of another part
  std::vector<Box> boxes_;    // of them
  std::optional<BoxTree> faceTree_;
  std::vector<bool> isSeen_;  // #V
  std::vector<Index> near_;   // faces of other parts that are near the present one, part by part
  std::vector<Attachment> rows_;
  std::vector<Piercing> piercings_;
};

}  // namespace whittle
