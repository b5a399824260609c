#pragma once

#include "mesh/adjacency.h"
#include "methods/plastic/stiffness.h"

namespace whittle {

/// How the parts of a mesh may move as they are: what no held vertex keeps them from, and no elastic energy sees. Of a
/// part that nothing holds these are three shifts and three turns, about one held vertex three turns, about a line of
/// them one.
class RigidModes {
 public:
  using Rows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

  /// @param nodeOf as that of `Stiffness`, −1 for held vertices
  /// @param parts of the mesh, each with a face
  void find(const Points& positions, const Components& parts, const std::vector<Index>& nodeOf);

  Index count() const { return count_; }
  /// The velocity of a vertex in each mode, 3×#modes.
  Eigen::Matrix3Xd velocities(Index vertex) const;

  /// Takes the modes out of columns of displacements of the nodes, or of forces on them (3 #nodes×k).
  void takeOut(Rows& columns) const;

  /// Holds each floating part as a table is held that stands on three points: by springs that bear nothing where forces
  /// are in balance, so that the stiffness becomes definite and solutions stay what they are.
  void addSupports(double spring, Stiffness& stiffness) const;

  /// Moves positions by a share of the modes, as the finite screws that they begin.
  void move(const Scalars& amounts, double share, Points& positions) const;

 private:
  struct Part {
    Vec3 center;
    Eigen::Matrix<double, 6, Eigen::Dynamic, 0, 6, 6> modes;  // turn, shift; orthonormal over the part's free vertices
    std::vector<Index> vertices, nodes;                       // the free ones
    Index first = 0;                                          // column of its first mode
    std::vector<std::pair<Index, Mat3>> supports;             // node and along what it is held
  };

  static Eigen::Matrix<double, 3, 6> velocity(const Part& part, const Vec3& position);
  void addPart(const Points& positions, const std::vector<Index>& vertices, const std::vector<Index>& nodeOf);
  void support(const Points& positions, const std::vector<Vec3>& held, Part& part) const;

  Points positions_;
  std::vector<Index> partOf_;  // #V, or −1
  std::vector<Part> parts_;
  Index count_ = 0;
};

}  // namespace whittle
