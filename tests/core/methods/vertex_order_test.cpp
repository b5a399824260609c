#include "methods/vertex_order.h"

#include <doctest/doctest.h>

#include <algorithm>

#include "support/shapes.h"

using namespace whittle;
using namespace whittle::testing;

TEST_CASE("a vertex order takes everything that belongs to vertices along, and gives the mesh back") {
  const TriangleMesh mesh = together(bent(sphere(2)), moebiusStrip(9), {3, 0, 0});
  const Index n = mesh.vertexCount();
  VertexOrdering ordering(mesh);
  while (ordering.next() < 1) {
  }
  const VertexOrder order = ordering.take();
  std::vector<int> seen(n, 0);
  for (Index place = 0; place < n; ++place) ++seen[order.vertexAt(place)];
  CHECK(std::all_of(seen.begin(), seen.end(), [](int times) { return times == 1; }));

  const TriangleMesh ordered = order.ordered(mesh);
  for (Index f = 0; f < mesh.faceCount(); ++f) {
    for (int k = 0; k < 3; ++k) CHECK(order.vertexAt(ordered.triangles(f, k)) == mesh.triangles(f, k));
  }
  for (Index place = 0; place < n; ++place)
    CHECK(ordered.positions.row(place) == mesh.positions.row(order.vertexAt(place)));
  const TriangleMesh again = order.asLoaded(ordered);
  CHECK(again.positions == mesh.positions);
  CHECK(again.triangles == mesh.triangles);

  const Scalars numbers = Scalars::LinSpaced(n, 0, n - 1);
  const Scalars moved = order.orderedRows(numbers);
  for (Index place = 0; place < n; ++place) {
    CHECK(moved[place] == order.vertexAt(place));
    CHECK(order.placeOf(order.vertexAt(place)) == place);
  }
  CHECK(order.rowsAsLoaded(moved) == numbers);
}
