#pragma once

#include <array>
#include <optional>
#include <vector>

#include "mesh/bounding_box.h"
#include "remeshing/delaunay.h"

namespace whittle {

/// Edges through the space between the parts of a mesh, which tie each to those around it.
struct Scaffold {
  /// The shortest length that an edge counts with, as a share of the mesh's longest side: parts that almost touch get a
  /// firm tie, and not one beyond all others.
  static constexpr double kLeastLength = 1e-3;

  struct Edge {
    Index first, second;  // first < second
    double length;        // at rest, and at least `kLeastLength`
  };

  /// Between vertices of different parts. They tie all parts together, each to the others.
  std::vector<Edge> betweenParts;
  /// From vertices to corners of a box around the mesh, which are numbered #V … #V + 7. The paper has them, with the
  /// corners free; they hold parts a little to their place in the whole, and may be left out.
  std::vector<Edge> toCorners;
  Points corners = Points(0, 3);  // 8×3, their places at rest
};

/// Builds the scaffold of a mesh: those edges of a Delaunay tetrahedralization of its vertices and a box's corners that
/// join different parts. Takes time about linear in the vertices; where space is cut up out of all proportion, as
/// between two finely divided lines, by fewer vertices of each part. Goes slice by slice.
///
/// Vertices within a millionth of the box are one place, with one vertex of each part there. No edge joins those, which
/// would have no length: they are tied as each part there has edges of its own to the places around, from which the
/// parts of those places are reached as well.
class ScaffoldSearch {
 public:
  /// @param positions #V×3, to be kept by the caller; finite
  /// @param partOfVertex #V, numbers of two parts and more, any that are not negative; −1 for vertices to be left out
  ScaffoldSearch(const Points& positions, std::vector<Index> partOfVertex);

  /// Does a slice of some 10 ms; returns the share that is done, 1 at the end.
  double next();
  /// What was built, once all is done.
  Scaffold take() { return std::move(scaffold_); }

 private:
  static constexpr Index kCorners = 8;

  /// Vertices in one place, one of each part: vertices_[first] … vertices_[last − 1].
  struct Place {
    LatticePoint point;
    Index first, last;
  };

  enum class Stage { places, adding, counting, collecting, emitting, done };

  double share() const;
  void enter(Stage stage);
  void measureBox();
  void collectPlaces();
  void orderPlaces();
  void addPlaces();
  template <typename Visit>
  bool visitEdges(Visit&& visit);
  void countEdges();
  void collectEdges();
  void emitEdges();
  void tie(const Place& a, const Place& b);
  void tieToCorner(const Place& place, int corner);
  Index firstOfOthers(Index part, const Place& place) const;
  bool haveSeveralParts(const Place& a, const Place& b) const;
  const Place& placeOf(Index point) const { return places_[order_[point - kCorners]]; }
  Scaffold::Edge edge(Index v, Index w, const Eigen::RowVector3d& from, const Eigen::RowVector3d& to) const;
  LatticePoint onLattice(const Eigen::RowVector3d& position) const;

  const Points& positions_;
  std::vector<Index> partOf_;
  Stage stage_ = Stage::places;
  Box box_;           // with a margin
  double scale_ = 0;  // to the lattice
  double least_ = 0;  // length of edges
  std::vector<Place> places_;
  std::vector<Index> vertices_;
  std::vector<Index> order_;  // places as they are added; point 8 + i is that of order_[i]
  Index mustAdd_ = 0;         // so many of these first ones, so that no part is left out
  Index next_ = 0;
  std::optional<DelaunayTetrahedra> tetrahedra_;
  std::vector<Index> start_, ends_;  // of each point, the larger ends of its edges, some several times
  Scaffold scaffold_;
};

}  // namespace whittle
