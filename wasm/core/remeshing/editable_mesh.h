#pragma once

#include <array>
#include <vector>

#include "mesh/edges.h"
#include "mesh/triangle_mesh.h"
#include "remeshing/derived_mesh.h"

namespace whittle {

/// A triangle mesh whose edges are split, collapsed and flipped. Each vertex has the list of its corners, and an edge is
/// what faces share of it: nothing asks for a manifold, an orientation or a closed surface. Corner k of face f is 3f + k,
/// and so is its half edge to the next corner (mesh/edges.h). Removed elements leave gaps until `derived`.
class EditableMesh {
 public:
  explicit EditableMesh(const TriangleMesh& mesh);

  /// Vertices and faces that there are or were.
  Index vertexCount() const { return static_cast<Index>(positions_.size()); }
  Index faceCount() const { return static_cast<Index>(faceOrigins_.size()); }

  const Vec3& position(Index v) const { return positions_[v]; }
  /// Moves a vertex, which is then not in the place of its origin any more.
  void move(Index v, const Vec3& position);
  /// Vertex at a corner.
  Index vertex(Index corner) const { return corners_[corner]; }
  Index tail(Index halfEdge) const { return corners_[halfEdge]; }
  Index head(Index halfEdge) const { return corners_[nextInFace(halfEdge)]; }
  Index opposite(Index halfEdge) const { return corners_[previousInFace(halfEdge)]; }
  bool isFace(Index f) const { return corners_[3 * f] >= 0; }
  bool isUsed(Index v) const { return first_[v] >= 0; }
  Index cornerCount(Index v) const { return counts_[v]; }
  Index origin(Index face) const { return faceOrigins_[face]; }

  /// The crease line on which a half edge lies, or −1. All half edges along an edge lie on one.
  Index line(Index halfEdge) const { return lines_[halfEdge]; }
  void setLine(Index a, Index b, Index line);

  /// Calls `visit(corner)` for the corners at a vertex; visit may take the corner away.
  template <typename Visit>
  void forEachCorner(Index v, Visit&& visit) const {
    for (Index corner = first_[v]; corner >= 0;) {
      const Index next = next_[corner];
      visit(corner);
      corner = next;
    }
  }
  /// Calls `visit(halfEdge)` for the half edges between two vertices, whichever way they run.
  template <typename Visit>
  void forEachAlong(Index a, Index b, Visit&& visit) const {
    if (counts_[b] < counts_[a]) std::swap(a, b);
    forEachCorner(a, [&](Index corner) {
      if (head(corner) == b) visit(corner);
      const Index in = previousInFace(corner);
      if (tail(in) == b) visit(in);
    });
  }
  Index faceCountAlong(Index a, Index b) const;
  /// Another half edge along the same edge, if there is exactly one; otherwise −1.
  Index twin(Index halfEdge) const;
  bool hasFace(Index a, Index b, Index c) const;

  /// Twice the area times the unit normal.
  Vec3 areaNormal(Index face) const;
  /// The same with vertex v elsewhere.
  Vec3 areaNormal(Index face, Index v, const Vec3& elsewhere) const;

  /// Puts vertex v on the edge from a to b: each face along it becomes two.
  void splitEdge(Index a, Index b, Index v);
  Index addVertex(const Vec3& position);

  /// Whether moving b into a leaves every neighbourhood what it is but for the faces along their edge (the link
  /// condition), and makes no face twice.
  bool canCollapse(Index a, Index b);
  /// Puts a in the place of b, whose faces along the edge between them go. Lines stay lines.
  void collapse(Index a, Index b);

  /// Whether the two faces along a half edge can be exchanged for those on both sides of its opposite vertices.
  bool canFlip(Index halfEdge) const;
  void flip(Index halfEdge);

  void removeFace(Index face);

  /// What is left, without gaps: vertices and faces in their order. Vertices that lost their faces go.
  DerivedMesh derived() const;

  static Index nextInFace(Index halfEdge) { return halfEdge % 3 == 2 ? halfEdge - 2 : halfEdge + 1; }
  static Index previousInFace(Index halfEdge) { return halfEdge % 3 == 0 ? halfEdge + 2 : halfEdge - 1; }

 private:
  Index addFace(Index a, Index b, Index c, Index origin);
  void hang(Index corner, Index v);  // into the list of v
  void unhang(Index corner);
  void setCorner(Index corner, Index v);

  std::vector<Vec3> positions_;
  std::vector<Index> origins_;         // of the vertices, or −1
  std::vector<bool> wasUsed_;          // of the original's vertices
  std::vector<Index> first_, counts_;  // of the corners of each vertex
  std::vector<Index> corners_;         // 3 #F, −1 in removed faces
  std::vector<Index> next_, previous_, lines_;
  std::vector<Index> faceOrigins_;
  std::vector<Index> stamps_;  // #V: the last question in which a vertex was seen
  Index stamp_ = 0;
};

}  // namespace whittle
