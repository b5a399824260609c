#pragma once

#include <vector>

#include "mesh/edges.h"
#include "mesh/triangle_mesh.h"

namespace whittle {

/// Creases of a surface as lines of edges from corner to corner, on which vertices may be placed anew. A corner is a
/// vertex where other than two creases meet, or where one turns sharply; closed lines are cut at three vertices, so that
/// a place on any line is a length from its first corner.
class CreaseLines {
 public:
  static constexpr Index kNone = -1, kCorner = -2;

  /// @param isCrease #E
  /// @param isCorner #V, vertices that are corners whatever meets there
  CreaseLines(const TriangleMesh& mesh, const MeshEdges& edges, const std::vector<bool>& isCrease,
              std::vector<bool> isCorner);

  const std::vector<Index>& ofEdges() const { return ofEdges_; }        // #E, kNone off the lines
  const std::vector<Index>& ofVertices() const { return ofVertices_; }  // #V, kNone, kCorner or a line
  const std::vector<double>& along() const { return along_; }           // #V, place on its line

  double length(Index line) const { return lines_[line].along.back(); }
  /// Place of a corner on a line that begins or ends there.
  double cornerPlace(Index line, Index corner) const { return lines_[line].first == corner ? 0 : length(line); }
  Vec3 at(Index line, double place) const;
  /// How far the line between two of its places is from the straight way.
  double deviation(Index line, double from, double to) const;

 private:
  struct Line {
    Index first, last;  // corners
    std::vector<Vec3> points;
    std::vector<double> along;
  };

  void gather(const MeshEdges& edges, const std::vector<bool>& isCrease);
  void findCorners(const TriangleMesh& mesh, std::vector<bool>& isCorner) const;
  void cutLoops(const TriangleMesh& mesh, std::vector<bool>& isCorner) const;
  /// The vertices on the way from a vertex along a crease, up to a corner or round to where it began.
  std::vector<Index> walk(Index vertex, Index edge, const std::vector<bool>& isCorner) const;
  void add(const TriangleMesh& mesh, Index vertex, Index edge, const std::vector<bool>& isCorner);

  struct End {
    Index vertex, edge;  // where an edge leads, and which it is
  };
  std::vector<Index> start_;  // #V + 1: creases at vertex v are ends_[start_[v]] …
  std::vector<End> ends_;
  std::vector<Line> lines_;
  std::vector<Index> ofEdges_, ofVertices_;
  std::vector<double> along_;
};

}  // namespace whittle
