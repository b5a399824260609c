#pragma once

#include <array>
#include <vector>

#include "remeshing/crease_lines.h"
#include "remeshing/editable_mesh.h"
#include "remeshing/patch_surface.h"

namespace whittle {

/// A surface on its way to faces of even size and shape. Vertices on creases keep to their lines, corners keep their
/// places, all others keep to the patch that they lie on. The four steps of isotropic remeshing each work on a range of
/// elements, so that sweeps can be cut into slices.
class RemeshedSurface {
 public:
  /// @param shape and what was found of it, to be kept by the caller
  /// @param tolerance how far from its crease an edge may be
  RemeshedSurface(const TriangleMesh& shape, const MeshEdges& edges, const PatchSurface& patches,
                  const CreaseLines& lines, double tolerance);

  const EditableMesh& mesh() const { return mesh_; }

  /// Cuts edges of a face that are longer than 4/3 of what they are to be, times `scale`. Returns whether there were.
  bool split(Index face, double scale);
  /// Collapses an edge of a face that is shorter than 4/5 of what it is to be, where no edge becomes longer than 4/3 of
  /// that times `scale`, no face is turned and no line left. Returns whether one was.
  bool collapse(Index face, double scale);
  /// Flips edges of a face that are not Delaunay. Returns whether one was.
  bool flip(Index face);
  /// Moves a vertex to the middle of its neighbourhood.
  void smooth(Index vertex);
  /// Limits the length of edges at a vertex by those of its neighbours.
  void grade(Index vertex);
  /// Asks of the surface anew how long edges at a vertex are to be.
  void measure(Index vertex) { sizes_[vertex] = wanted_[vertex]; }

 private:
  /// A collapse that may be done: `gone` goes into `kept`, which moves to `place`.
  struct Collapse {
    Index kept, gone;
    Vec3 place;
  };

  bool isFree(Index v) const { return lineOf_[v] == CreaseLines::kNone; }
  double target(Index a, Index b) const { return (sizes_[a] + sizes_[b]) / 2; }
  double edgeLength(Index a, Index b) const { return (mesh_.position(a) - mesh_.position(b)).norm(); }
  /// Place of a vertex on a line that it is on, or a corner of.
  double placeOn(Index line, Index v) const { return lineOf_[v] == line ? along_[v] : lines_.cornerPlace(line, v); }

  void splitEdge(Index halfEdge);
  Vec3 middle(Index halfEdge, Index& foot) const;
  bool splitsWell(Index a, Index b, const Vec3& place) const;

  bool collapseEdge(Index halfEdge, double scale);
  /// Whether the line of b can do without it, with a next to it.
  bool canLeaveLine(Index a, Index b, Index line) const;
  bool mergesCreases(Index a, Index b) const;
  bool isGood(const Collapse& collapse, double scale);
  bool keepsShapes(Index v, const Collapse& collapse) const;
  bool keepsBends(const Collapse& collapse) const;
  Vec3 normalAfter(Index face, const Collapse& collapse) const;
  void apply(const Collapse& collapse);

  bool isDelaunay(Index halfEdge, Index other) const;
  bool flipsWell(Index halfEdge, Index other) const;

  void smoothOnLine(Index v);
  void smoothOnPatch(Index v);
  bool movesWell(Index v, const Vec3& place) const;
  /// The ends of the two pieces of its line at a vertex on one.
  std::array<Index, 2> lineNeighbours(Index v) const;

  const PatchSurface& patches_;
  const CreaseLines& lines_;
  double tolerance_;
  EditableMesh mesh_;
  std::vector<Index> lineOf_;           // #V
  std::vector<double> along_;           // #V
  std::vector<double> wanted_, sizes_;  // #V, length of edges by the surface, and graded
  std::vector<Index> feet_;             // #V, the face of the shape on which a free vertex lies
};

}  // namespace whittle
