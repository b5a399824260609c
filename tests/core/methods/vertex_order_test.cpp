#include "methods/vertex_order.h"

#include <doctest/doctest.h>

#include <algorithm>

#include "support/shapes.h"

using namespace whittle;
using namespace whittle::testing;

TEST_CASE("a vertex order takes everything that belongs to vertices along, and gives the mesh back") {
  const TriangleMesh mesh = together(bent(sphere(2)), moebiusStrip(9), {3, 0, 0});
  const Index n = mesh.vertexCount();
  const VertexOrder order = VertexOrder::of(mesh);
  std::vector<int> seen(n, 0);
  for (Index place = 0; place < n; ++place) ++seen[order.vertexAt(place)];
  CHECK(std::all_of(seen.begin(), seen.end(), [](int times) { return times == 1; }));

  const TriangleMesh ordered = order.ordered(mesh);
  for (Index f = 0; f < mesh.faceCount(); ++f) {
    for (int k = 0; k < 3; ++k) CHECK(order.vertexAt(ordered.triangles(f, k)) == mesh.triangles(f, k));
  }
  for (Index place = 0; place < n; ++place) CHECK(ordered.positions.row(place) == mesh.positions.row(order.vertexAt(place)));
  const TriangleMesh again = order.inFileOrder(ordered);
  CHECK(again.positions == mesh.positions);
  CHECK(again.triangles == mesh.triangles);

  const std::vector<ParameterInfo> infos = {{"number", ParameterKind::number, Stale::all},
                                            {"scalars", ParameterKind::scalars, Stale::all},
                                            {"rotations", ParameterKind::rotations, Stale::all},
                                            {"none", ParameterKind::scalars, Stale::all}};
  Settings settings = Settings::defaults(infos);
  settings.scalars[1].setLinSpaced(n, 0, n - 1);
  settings.scalars[2].setLinSpaced(4 * n, 0, 4 * n - 1);
  settings.handles = {{5, 70}, Points::Zero(2, 3)};
  const Settings moved = order.ordered(settings, infos);
  for (Index place = 0; place < n; ++place) {
    CHECK(moved.scalars[1][place] == order.vertexAt(place));
    for (int i = 0; i < 4; ++i) CHECK(moved.scalars[2][4 * place + i] == 4 * order.vertexAt(place) + i);
  }
  CHECK(moved.scalars[3].size() == 0);
  CHECK(order.vertexAt(moved.handles.vertices[0]) == 5);
  CHECK(order.vertexAt(moved.handles.vertices[1]) == 70);
}
