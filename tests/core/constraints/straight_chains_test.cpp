#include "constraints/straight_chains.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "geometry/feature_edges.h"
#include "support/round_shapes.h"
#include "support/shapes.h"

using namespace whittle;
using namespace whittle::testing;

namespace {

VertexChains chainsOf(const TriangleMesh& mesh) {
  const MeshEdges edges(mesh.triangles, mesh.vertexCount());
  const auto pairs = facePairs(mesh.positions, mesh.triangles, edges);
  return straightChains(mesh.positions, edges, featureEdges(pairs, edges.count(), 40 * EIGEN_PI / 180));
}

/// Chains of lines in space alone, each a way along edges; a vertex has one place in all of them.
VertexChains chainsOfLines(const Points& places, const VertexChains& lines) {
  MeshEdges edges;
  for (const auto& line : lines) {
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
      edges.ends.push_back({std::min(line[i], line[i + 1]), std::max(line[i], line[i + 1])});
    }
  }
  std::sort(edges.ends.begin(), edges.ends.end());
  return straightChains(places, edges, std::vector<bool>(edges.ends.size(), true));
}

/// Vertices 0, 1, 2, …, each edge of length 1 and turned on from the one before by some degrees.
Points turtle(const std::vector<double>& turns) {
  Points places = Points::Zero(static_cast<Index>(turns.size()) + 2, 3);
  double heading = 0.4;
  for (Index v = 1; v < places.rows(); ++v) {
    if (v > 1) heading += turns[v - 2] * EIGEN_PI / 180;
    places.row(v) = places.row(v - 1) + Eigen::RowVector3d(std::cos(heading), std::sin(heading), 0.3);
  }
  return places;
}

std::vector<Index> countingTo(Index count) {
  std::vector<Index> line(count);
  for (Index i = 0; i < count; ++i) line[i] = i;
  return line;
}

VertexChains chainsOfTurtle(const std::vector<double>& turns) {
  const Points places = turtle(turns);
  return chainsOfLines(places, {countingTo(static_cast<Index>(places.rows()))});
}

}  // namespace

TEST_CASE("the straight chains of a box are its twelve sides, from corner to corner") {
  const auto chains = chainsOf(turned(longBox(4, 3)));
  REQUIRE(chains.size() == 12);
  CHECK(std::count_if(chains.begin(), chains.end(), [](const auto& chain) { return chain.size() == 5; }) == 4);
  CHECK(std::count_if(chains.begin(), chains.end(), [](const auto& chain) { return chain.size() == 4; }) == 8);
  CHECK(chainsOf(longBox(1, 1)).empty());  // edges alone are straight anyhow
}

TEST_CASE("an L of cubes has eighteen sides, and smooth bodies and rims have none") {
  CHECK(chainsOf(turned(blocks({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, 3))).size() == 18);
  CHECK(chainsOf(sphere(3)).empty());
  for (const int sides : {12, 100, 400}) CHECK(chainsOf(cylinder(sides, 3, 2, 0.3, 1, true)).empty());
}

TEST_CASE("a line goes on where another begins or crosses, and ends where nobody can say in which it goes on") {
  Points cross(7, 3);
  cross << -2, 0, 0, -1, 0, 0, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, -1, 0, 1, 0.02, 0;
  CHECK(chainsOfLines(cross, {{0, 1, 2, 3}, {2, 4}}) == VertexChains{{0, 1, 2, 3}});
  CHECK(chainsOfLines(cross, {{0, 1, 2, 3}, {4, 2, 5}}) == VertexChains{{0, 1, 2, 3}, {5, 2, 4}});
  CHECK(chainsOfLines(cross, {{0, 1, 2, 3}, {2, 6}}) == VertexChains{{0, 1, 2}});
}

TEST_CASE("a chain ends where it bends by more than two degrees") {
  CHECK(chainsOfTurtle({0, 1.5, -1.5, 0}) == VertexChains{{0, 1, 2, 3, 4, 5}});
  CHECK(chainsOfTurtle({0, 2.5, 0, 0}) == VertexChains{{0, 1, 2}, {2, 3, 4, 5}});
  CHECK(chainsOfTurtle({2.5, 2.5}).empty());
}

TEST_CASE("an arc of small steps is no chain, and a line that passes into it is one up to there") {
  CHECK(chainsOfTurtle(std::vector<double>(60, 1)).empty());
  std::vector<double> turns(40, 0);
  std::fill(turns.begin() + 20, turns.end(), 0.8);
  CHECK(chainsOfTurtle(turns) == VertexChains{countingTo(22)});
  // A stadium: two lines and two arcs, closed, wherever its numbers begin.
  for (const Index first : {0, 5, 200}) {
    const Index around = 380;  // ten edges, 180 turns of a degree, and the same again
    Points places(around, 3);
    Eigen::RowVector3d place = Eigen::RowVector3d::Zero();
    double heading = 0;
    VertexChains ring(1);
    for (Index i = 0; i < around; ++i) {
      places.row((i + first) % around) = place;
      ring[0].push_back((i + first) % around);
      place += Eigen::RowVector3d(std::cos(heading), std::sin(heading), 0);
      if (i % 190 >= 9 && i % 190 < 189) heading += EIGEN_PI / 180;
    }
    ring[0].push_back(ring[0].front());
    const auto chains = chainsOfLines(places, ring);
    REQUIRE(chains.size() == 2);
    for (const auto& chain : chains) CHECK(chain.size() == 12);
  }
}

TEST_CASE("a star of many lines takes no square of time") {
  const Index count = 100000;
  Points places = Points::Zero(count + 1, 3);
  VertexChains rays;
  for (Index i = 1; i <= count; ++i) {
    places.row(i) << std::cos(0.001 * i), std::sin(0.001 * i), i;
    rays.push_back({0, i});
  }
  CHECK(chainsOfLines(places, rays).empty());
}
