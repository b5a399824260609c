#pragma once

#include <array>
#include <vector>

#include "base/types.h"
#include "remeshing/lattice.h"

namespace whittle {

/// A Delaunay tetrahedralization that grows point by point (Bowyer and Watson): no point lies within the sphere of a
/// tetrahedron. Where more than four lie on an empty sphere any of the ways to fill it may come out, depending on the
/// order of the points but on nothing else. Predicates are exact, so that no tetrahedron is flat or turned inside out.
class DelaunayTetrahedra {
 public:
  struct Tetrahedron {
    std::array<Index, 4> points;      // of positive orientation; points[0] is −1 where there is none any more
    std::array<Index, 4> neighbours;  // across the face opposite to each point; −1 outside the box
  };

  /// Fills a box; its eight corners are the points 0 … 7, the lowest axis first: point 1 is that at high.x.
  DelaunayTetrahedra(const LatticePoint& low, const LatticePoint& high);

  /// Claims memory for so many points in all.
  void reserve(Index pointCount);
  /// Adds a point strictly within the box and apart from all others; returns its number. Takes time by how many
  /// tetrahedra it changes, if it is near to the point before.
  Index add(const LatticePoint& point);

  const LatticePoint& point(Index number) const { return points_[number]; }
  Index pointCount() const { return static_cast<Index>(points_.size()); }
  /// All there are, and some there are no more.
  const std::vector<Tetrahedron>& tetrahedra() const { return tetrahedra_; }
  /// How many tetrahedra were made so far, those that are no more among them: what it took.
  std::int64_t made() const { return made_; }

 private:
  /// A face of the cavity that a new point makes: of a tetrahedron that goes, towards one that stays.
  struct Face {
    Index tetrahedron;
    int side;  // opposite to this point of it
  };

  void joinNeighbours();
  Index locate(const LatticePoint& point);
  bool isBeyond(const LatticePoint& point, const Tetrahedron& tetrahedron, int side) const;
  void findCavity(Index first, const LatticePoint& point);
  Index claim();
  void fillCavity(Index point);
  Index acrossCavity(Face face, int pivot) const;
  int sideTo(Index tetrahedron, Index neighbour) const;

  std::vector<LatticePoint> points_;
  std::vector<Tetrahedron> tetrahedra_;
  std::vector<std::array<Index, 4>> filled_;  // of each face of the cavity, the tetrahedron on it and the new point
  std::vector<Index> seen_;                   // 2 · point + 1 where one goes for a point, 2 · point where one stays
  std::vector<Index> free_;                   // places of tetrahedra that are no more
  std::vector<Index> cavity_;
  std::vector<Face> faces_;
  std::int64_t made_ = 0;
  Index last_ = 0;  // where the next walk begins
  std::uint32_t turn_ = 1;
};

}  // namespace whittle
