#include "remeshing/scaffold.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <set>
#include <utility>

#include "mesh/adjacency.h"
#include "mesh/disjoint_sets.h"
#include "support/shapes.h"

using namespace whittle;
using namespace whittle::testing;

namespace {

using Pairs = std::set<std::pair<Index, Index>>;

Scaffold scaffoldOf(const Points& positions, const std::vector<Index>& parts) {
  ScaffoldSearch search(positions, parts);
  double share = 0;
  while (share < 1) {
    const double before = share;
    share = search.next();
    REQUIRE(share > before);
  }
  CHECK(search.next() == 1);
  return search.take();
}

std::vector<Index> partsOf(const TriangleMesh& mesh) {
  return connectedComponents(mesh.triangles, mesh.vertexCount()).ofVertex;
}

Pairs pairsOf(const std::vector<Scaffold::Edge>& edges) {
  Pairs pairs;
  for (const auto& edge : edges) pairs.emplace(edge.first, edge.second);
  return pairs;
}

/// How many sets of parts there are that no edge ties to another.
Index tiedGroups(const Scaffold& scaffold, const std::vector<Index>& parts) {
  Index groups = *std::max_element(parts.begin(), parts.end()) + 1;
  DisjointSets sets(groups);
  for (const auto& edge : scaffold.betweenParts) groups -= sets.join(parts[edge.first], parts[edge.second]);
  return groups;
}

/// Checks what every scaffold is: edges once, between parts, as long as they are.
void checkEdges(const Scaffold& scaffold, const Points& positions, const std::vector<Index>& parts) {
  const Index count = static_cast<Index>(positions.rows());
  for (const auto& edge : scaffold.betweenParts) {
    CHECK(edge.first < edge.second);
    CHECK(parts[edge.first] != parts[edge.second]);
    const double length = (positions.row(edge.first) - positions.row(edge.second)).norm();
    CHECK(edge.length >= length);
    CHECK((edge.length == length || length < 0.01));
  }
  for (const auto& edge : scaffold.toCorners) {
    CHECK(edge.first < count);
    CHECK(edge.second >= count);
    const Vec3 between = (positions.row(edge.first) - scaffold.corners.row(edge.second - count)).transpose();
    CHECK(edge.length == between.norm());
  }
  CHECK(pairsOf(scaffold.betweenParts).size() == scaffold.betweenParts.size());
  CHECK(pairsOf(scaffold.toCorners).size() == scaffold.toCorners.size());
}

Scaffold checkedScaffold(const TriangleMesh& mesh) {
  const auto parts = partsOf(mesh);
  const Scaffold scaffold = scaffoldOf(mesh.positions, parts);
  checkEdges(scaffold, mesh.positions, parts);
  CHECK(tiedGroups(scaffold, parts) == 1);
  return scaffold;
}

}  // namespace

TEST_CASE("two blocks are tied where they face each other, and to a box around both") {
  const TriangleMesh block = blocks({{0, 0, 0}}, 4), mesh = together(block, block, {1.25, 0, 0});
  const Scaffold scaffold = checkedScaffold(mesh);
  Index straight = 0;
  for (const auto& edge : scaffold.betweenParts) {
    CHECK(mesh.positions(edge.first, 0) == 1);
    CHECK(mesh.positions(edge.second, 0) == 1.25);
    straight += edge.length < 0.2500001;
  }
  CHECK(straight == 25);
  REQUIRE(scaffold.corners.rows() == 8);
  const double margin = 0.05 * 2.25;
  CHECK(scaffold.corners.row(0).isApprox(Eigen::RowVector3d(-margin, -margin, -margin)));
  CHECK(scaffold.corners.row(1).isApprox(Eigen::RowVector3d(2.25 + margin, -margin, -margin)));
  CHECK(scaffold.corners.row(7).isApprox(Eigen::RowVector3d(2.25 + margin, 1 + margin, 1 + margin)));
  CHECK(scaffold.toCorners.size() >= 8);
}

TEST_CASE("parts in any arrangement are all tied, without the corners too") {
  checkedScaffold(together(sphere(3), sphere(2), {5, 7, -3}));
  checkedScaffold(together(torus(20), torus(20), {0.7, 0.1, 0}));
  checkedScaffold(together(grid(9), grid(9), {0, 0, 0.001}));
  checkedScaffold(together(grid(5), grid(5), {40, 0, 0}));
  TriangleMesh many = blocks({{0, 0, 0}}, 1);
  for (int i = 1; i < 40; ++i) many = together(many, blocks({{0, 0, 0}}, 1), {i % 3 * 1.5, i % 7 * 2.0, i * 0.3});
  checkedScaffold(many);
  TriangleMesh inside = sphere(3);
  inside.positions *= 0.2;
  checkedScaffold(together(sphere(3), inside, Vec3::Zero()));
}

TEST_CASE("parts that share places have no edge without length, and are tied by the places around") {
  const TriangleMesh block = blocks({{0, 0, 0}}, 2);
  const Scaffold touching = checkedScaffold(together(block, block, {1, 0, 0}));
  for (const auto& edge : touching.betweenParts) CHECK(edge.length > 0.4);
  checkedScaffold(together(sphere(2), sphere(2), Vec3::Zero()));
  checkedScaffold(together(together(sphere(1), sphere(1), Vec3::Zero()), sphere(1), Vec3::Zero()));
  // Two triangles that share a corner of one place.
  Points fans(6, 3);
  fans << 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 0, -1, 0, 0, 0, -1, 0.5;
  const Scaffold scaffold = scaffoldOf(fans, {0, 0, 0, 1, 1, 1});
  CHECK(pairsOf(scaffold.betweenParts).count({0, 3}) == 0);
  CHECK(tiedGroups(scaffold, {0, 0, 0, 1, 1, 1}) == 1);
  // Several parts in one place, one or several in the other: each has its edge, and none two.
  Points pairs(5, 3);
  pairs << 0, 0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 0, 0, 0;
  CHECK(pairsOf(scaffoldOf(pairs.topRows<4>(), {0, 1, 2, 3}).betweenParts) == Pairs{{0, 1}, {0, 2}, {0, 3}});
  CHECK(pairsOf(scaffoldOf(pairs, {0, 0, 1, 2, 1}).betweenParts) == Pairs{{0, 2}, {0, 3}, {1, 4}});
  CHECK(pairsOf(scaffoldOf(pairs, {0, 1, 1, 1, 1}).betweenParts) == Pairs{{0, 1}});
}

TEST_CASE("parts that almost touch are tied no firmer than by a thousandth of the mesh") {
  const TriangleMesh block = blocks({{0, 0, 0}}, 2);
  const Scaffold scaffold = checkedScaffold(together(block, block, {1 + 1e-5, 0, 0}));
  const auto shortest = std::min_element(scaffold.betweenParts.begin(), scaffold.betweenParts.end(),
                                         [](const auto& a, const auto& b) { return a.length < b.length; });
  CHECK(shortest->length == doctest::Approx(2e-3).epsilon(1e-4));
}

TEST_CASE("vertices in another order have the same scaffold") {
  const TriangleMesh mesh = together(torus(14), blocks({{0, 0, 0}}, 3), {0.3, 0.2, 0.1}), other = shuffled(mesh);
  const Scaffold scaffold = checkedScaffold(mesh), ofOther = checkedScaffold(other);
  const Index count = mesh.vertexCount();
  Pairs renamed;
  for (const auto& edge : scaffold.betweenParts) {
    const auto [low, high] = std::minmax({shuffledPlace(edge.first, count), shuffledPlace(edge.second, count)});
    renamed.emplace(low, high);
  }
  CHECK(renamed == pairsOf(ofOther.betweenParts));
}

TEST_CASE("vertices of no part are left out, and what has no room has no edge") {
  const TriangleMesh mesh = together(sphere(2), sphere(2), {3, 0, 0});
  std::vector<Index> parts = partsOf(mesh);
  for (Index v = 0; v < mesh.vertexCount(); v += 2) parts[v] = -1;
  for (const auto& edge : scaffoldOf(mesh.positions, parts).betweenParts) {
    CHECK(edge.first % 2 == 1);
    CHECK(edge.second % 2 == 1);
  }
  CHECK(scaffoldOf(Points::Ones(3, 3), {0, 1, 2}).betweenParts.empty());
  CHECK(scaffoldOf(Points::Zero(2, 3), {-1, -1}).betweenParts.empty());
  CHECK(scaffoldOf(Points(0, 3), {}).betweenParts.empty());
}

TEST_CASE("two fine lines that pass each other are tied without a square of edges") {
  const Index count = 1500;
  Points lines(2 * count, 3);
  std::vector<Index> parts(2 * count, 0);
  for (Index i = 0; i < count; ++i) {
    lines.row(i) << static_cast<double>(i) / count, 0.5, 0;
    lines.row(count + i) << 0.5, static_cast<double>(i) / count, 0.7;
    parts[count + i] = 1;
  }
  const Scaffold scaffold = scaffoldOf(lines, parts);
  CHECK(tiedGroups(scaffold, parts) == 1);
  CHECK(scaffold.betweenParts.size() < 400000);
}
