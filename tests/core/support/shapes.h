#pragma once

#include <array>
#include <random>
#include <vector>

#include "mesh/triangle_mesh.h"

namespace whittle::testing {

/// A unit sphere from an octahedron, every edge cut in two `levels` times (6, 18, 66, 258, 1026, 4098 vertices).
TriangleMesh sphere(int levels);

/// A flat square in the plane z = 0 with `n`×`n` vertices and a boundary; side 1.
TriangleMesh grid(int n);

/// A Möbius strip: one side, one boundary.
TriangleMesh moebiusStrip(int n);

/// The skin of a box of `along`×`across`×`across` cells, each a cube of side 1/`across`.
TriangleMesh longBox(int along, int across);

/// The skin of cubes of side 1 at places of a grid, each with `across` cells along an edge.
TriangleMesh blocks(const std::vector<std::array<int, 3>>& cubes, int across);

/// An upright prism of `sides` sides, of height 1.5 and radius 1, turned about its axis by some radians; its two ends are
/// fans around their middles.
TriangleMesh prism(int sides, double turn);

/// A torus of `n`×`n` vertices.
TriangleMesh torus(int n);

/// A smooth body with a head, two ears and a tail, its triangles like those of `sphere(levels)`.
TriangleMesh animal(int levels);

/// One mesh of two, the second moved by `offset`.
TriangleMesh together(const TriangleMesh& first, const TriangleMesh& second, const Vec3& offset);

/// A smooth bend of a mesh, so that nothing is special about it.
TriangleMesh bent(TriangleMesh mesh);

/// A mesh with its vertices in another order: vertex v is then the one at `shuffledPlace(v, count)`.
TriangleMesh shuffled(const TriangleMesh& mesh);
Index shuffledPlace(Index v, Index count);

/// A rotation that is nobody's special case.
Mat3 someRotation();

/// Uniform in [−1, 1], the same numbers in every run and on every machine (draw them in statements or braces:
/// compilers order the arguments of a call as they like).
class Noise {
 public:
  double operator()() { return static_cast<double>(engine_()) / 2147483648.0 - 1.0; }
  Mat3 matrix();
  Mat3 rotation();
  Vec3 direction();
  /// U diag(values) V for random rotations U and V.
  Mat3 withSingularValues(const Vec3& values);

 private:
  std::mt19937 engine_{20191123u};
};

}  // namespace whittle::testing
