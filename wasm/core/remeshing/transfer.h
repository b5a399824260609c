#pragma once

#include <optional>
#include <vector>

#include "geometry/box_tree.h"
#include "mesh/adjacency.h"
#include "remeshing/derived_mesh.h"

namespace whittle {

/// Carries what becomes of a working mesh back to the mesh that it was made from. Each vertex of that input moves as
/// the nearest point of the working mesh's surface does, on a face that looks its way and belongs to its part: the two
/// sides of a thin plate, or parts that touch, are not taken for each other. A vertex that both meshes have in one place
/// takes the very place of its twin; a vertex without faces stays where it is. Found slice by slice.
class Transfer {
 public:
  /// @param input, working at rest, to be kept by the caller as they are
  Transfer(const TriangleMesh& input, const DerivedMesh& working);

  /// Does a slice of some 10 ms; returns the share that is done, 1 at the end.
  double next();

  /// Where the working mesh's vertices (#V of it ×3) take those of the input (#V×3): at rest, to the bit, to rest.
  /// Allocates nothing.
  void carry(const Points& working, Points& input) const;

  /// The point of the working mesh that a vertex of the input follows.
  struct Place {
    Index face = -1;  // of the working mesh, or −1 where the vertex has a twin or no faces
    Index twin = -1;  // the vertex of the working mesh in the same place
    Vec3 weights = Vec3::Zero();
  };
  const Place& place(Index vertex) const { return places_[vertex]; }

 private:
  void growTree();
  void findTwins();
  void findPlace(Index vertex);
  /// Whether a face of the working mesh looks the way of one of the vertex's faces.
  bool agrees(Index vertex, Index face) const;

  const TriangleMesh& input_;
  const DerivedMesh& working_;
  Fans fans_;  // of the input
  Points inputNormals_, workingNormals_;
  std::vector<Index> partOfVertex_, partOfFace_;  // of the input; of the working mesh
  double stray_ = 0;                              // squared distance that a face which does not suit has to make up for
  std::optional<BoxTree> tree_;
  Index next_ = 0;
  std::vector<Place> places_;
};

}  // namespace whittle
