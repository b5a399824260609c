#pragma once

#include <array>
#include <optional>
#include <vector>

#include "constraints/attachments.h"
#include "geometry/box_tree.h"
#include "mesh/triangle_mesh.h"

namespace whittle {

/// How near parts must be to touch, in the unit frame: what people leave between parts that are meant to be in touch.
constexpr double kContactReach = 2e-3;

/// Finds where parts of a mesh touch or cross: every vertex within reach of another part, at the nearest point of it,
/// every edge that goes through a face of another part, and long edges that cross one of another part within reach, as
/// those of planks that lie across each other. Goes slice by slice.
class ContactSearch {
 public:
  /// @param mesh in the unit frame, to be kept by the caller
  /// @param partOfFace #F, numbers below #V or #F
  ContactSearch(const TriangleMesh& mesh, std::vector<Index> partOfFace);

  /// Does a slice of some 10 ms; returns the share that is done, 1 at the end.
  double next();
  /// What was found, once all is done.
  std::vector<Attachment> take();

 private:
  /// An edge that meets a face of another part, or an edge of one.
  struct Meeting {
    std::array<Index, 4> place;  // the edge's ends, and the face and −1, or the other edge's ends
    Attachment row;
  };

  void growPartTree();
  /// Keeps a face that is near the box of another part.
  void sift(Index face);
  void compare(Index face);
  /// Attaches a vertex to the nearest point of each part that has a face in `near_`.
  void attachVertex(Index v);
  /// Attaches an edge where it goes through faces in `near_`.
  void attachEdge(Index v, Index w);
  /// Attaches a long edge where it crosses a long one of a face.
  void attachCrossed(Index v, Index w, Index face);
  Index partOf(Index face) const { return partOfFace_[face]; }
  Vec3 at(Index v) const { return mesh_.positions.row(v).transpose(); }
  Vec3 corner(Index face, int k) const { return at(mesh_.triangles(face, k)); }
  Box boxWithReach(Index face) const;

  const TriangleMesh& mesh_;
  std::vector<Index> partOfFace_;
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
  std::vector<Meeting> meetings_;
};

}  // namespace whittle
