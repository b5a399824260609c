#include "support/round_shapes.h"

#include <cmath>

#include "support/shapes.h"

namespace whittle::testing {

namespace {

Vec3 onCircle(double turn, double radius, double height) {
  const double angle = 2 * EIGEN_PI * turn;
  return {radius * std::cos(angle), radius * std::sin(angle), height};
}

}  // namespace

TriangleMesh sheet(const Weave& weave, const std::function<Vec3(double, double)>& place) {
  const int columns = weave.across + !weave.closedAcross, rows = weave.along + !weave.closedAlong;
  TriangleMesh mesh{Points(columns * rows, 3), Triangles(2 * weave.across * weave.along, 3)};
  const auto isShifted = [&](int j) { return weave.staggered && j % 2 == 1; };
  for (int j = 0; j < rows; ++j) {
    for (int i = 0; i < columns; ++i) {
      const double u = (i + (isShifted(j) ? 0.5 : 0)) / weave.across;
      mesh.positions.row(j * columns + i) = place(u, static_cast<double>(j) / weave.along).transpose();
    }
  }
  const auto at = [&](int i, int j) { return (j % rows) * columns + i % columns; };
  Index f = 0;
  for (int j = 0; j < weave.along; ++j) {
    for (int i = 0; i < weave.across; ++i) {
      const Index a = at(i, j), b = at(i + 1, j), c = at(i + 1, j + 1), d = at(i, j + 1);
      if (isShifted(j)) {
        mesh.triangles.row(f++) << a, b, c;
        mesh.triangles.row(f++) << a, c, d;
      } else {
        mesh.triangles.row(f++) << a, b, d;
        mesh.triangles.row(f++) << b, c, d;
      }
    }
  }
  return mesh;
}

TriangleMesh tube(int sides, int rows, double radius, double height, bool staggered) {
  return sheet({sides, rows, true, false, staggered},
               [&](double u, double v) { return onCircle(u, radius, height * v); });
}

TriangleMesh cylinder(int sides, int rows, int rings, double radius, double height, bool staggered) {
  TriangleMesh mesh = tube(sides, rows, radius, height, staggered);
  const auto addFace = [&](Index a, Index b, Index c) {
    mesh.triangles.conservativeResize(mesh.faceCount() + 1, 3);
    mesh.triangles.bottomRows<1>() << a, b, c;
  };
  const auto addVertex = [&](const Vec3& place) {
    mesh.positions.conservativeResize(mesh.vertexCount() + 1, 3);
    mesh.positions.bottomRows<1>() = place.transpose();
    return mesh.vertexCount() - 1;
  };
  for (const bool top : {false, true}) {
    const double z = top ? height : 0, shift = top && staggered && rows % 2 == 1 ? 0.5 : 0;
    std::vector<Index> rim(sides);
    for (int i = 0; i < sides; ++i) rim[i] = (top ? sides * rows : 0) + i;
    for (int ring = rings - 1; ring > 0; --ring) {
      std::vector<Index> inner(sides);
      for (int i = 0; i < sides; ++i) inner[i] = addVertex(onCircle((i + shift) / sides, radius * ring / rings, z));
      for (int i = 0, next = 1; i < sides; ++i, next = (next + 1) % sides) {
        const Index a = rim[i], b = rim[next], c = inner[next], d = inner[i];
        addFace(a, top ? b : d, top ? d : b);
        addFace(b, top ? c : d, top ? d : c);
      }
      rim = inner;
    }
    const Index middle = addVertex({0, 0, z});
    for (int i = 0, next = 1; i < sides; ++i, next = (next + 1) % sides) {
      addFace(middle, rim[top ? i : next], rim[top ? next : i]);
    }
  }
  return mesh;
}

TriangleMesh turned(TriangleMesh mesh) {
  mesh.positions = (mesh.positions * someRotation().transpose()).eval();
  return mesh;
}

}  // namespace whittle::testing
