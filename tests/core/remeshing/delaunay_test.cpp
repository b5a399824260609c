#include "remeshing/delaunay.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>

#include "support/shapes.h"

using namespace whittle;
using namespace whittle::testing;

namespace {

constexpr LatticePoint kLow{0, 0, 0}, kHigh{(1 << 20) - 1, (1 << 20) - 1, (1 << 20) - 1};

std::int64_t volume(const DelaunayTetrahedra& all, const DelaunayTetrahedra::Tetrahedron& t) {
  return orientation(all.point(t.points[0]), all.point(t.points[1]), all.point(t.points[2]), all.point(t.points[3]));
}

/// Checks that it is a tetrahedralization of the box, none of it flat, with neighbours that know each other, and that
/// no point is within the sphere of another's tetrahedron.
void checkDelaunay(const DelaunayTetrahedra& all, const LatticePoint& low, const LatticePoint& high) {
  double filled = 0;
  Index faults = 0;
  std::set<Index> used;
  const auto& tetrahedra = all.tetrahedra();
  for (Index t = 0; t < static_cast<Index>(tetrahedra.size()); ++t) {
    const auto& p = tetrahedra[t].points;
    if (p[0] < 0) continue;
    used.insert(p.begin(), p.end());
    filled += static_cast<double>(volume(all, tetrahedra[t]));
    if (volume(all, tetrahedra[t]) <= 0) ++faults;
    for (const Index neighbour : tetrahedra[t].neighbours) {
      if (neighbour >= 0 &&
          std::count(tetrahedra[neighbour].neighbours.begin(), tetrahedra[neighbour].neighbours.end(), t) != 1) {
        ++faults;
      }
    }
    for (Index q = 0; q < all.pointCount(); ++q) {
      if (std::count(p.begin(), p.end(), q)) continue;
      faults += isInSphere(all.point(p[0]), all.point(p[1]), all.point(p[2]), all.point(p[3]), all.point(q));
    }
  }
  CHECK(faults == 0);
  CHECK(static_cast<Index>(used.size()) == all.pointCount());
  const double box = (static_cast<double>(high.x) - low.x) * (static_cast<double>(high.y) - low.y) *
                     (static_cast<double>(high.z) - low.z);
  CHECK(filled == doctest::Approx(6 * box).epsilon(1e-12));
}

void checkPoints(const std::vector<LatticePoint>& points) {
  DelaunayTetrahedra all(kLow, kHigh);
  for (const LatticePoint& point : points) all.add(point);
  checkDelaunay(all, kLow, kHigh);
}

std::int32_t onAxis(double x) { return static_cast<std::int32_t>(std::lround((x + 1) * 500000)) + 1000; }

LatticePoint at(const Vec3& place) { return {onAxis(place[0]), onAxis(place[1]), onAxis(place[2])}; }

}  // namespace

TEST_CASE("orientation and sphere are exact to the last place of the lattice") {
  constexpr std::int32_t most = (1 << 20) - 1;
  const LatticePoint o{0, 0, 0}, x{most, 0, 0}, y{0, most, 0}, z{0, 0, most}, xyz{most, most, most};
  CHECK(orientation(x, y, z, o) == std::int64_t{most} * most * most);
  CHECK(orientation(y, x, z, o) == -std::int64_t{most} * most * most);
  CHECK(orientation(x, y, {most, most, 0}, o) == 0);
  CHECK(orientation(x, y, {most, most, 1}, o) != 0);
  REQUIRE(orientation(x, y, z, o) > 0);
  CHECK(!isInSphere(x, y, z, o, xyz));
  CHECK(isInSphere(x, y, z, o, {most, most, most - 1}));
  CHECK(isInSphere(x, y, z, o, {1, 1, 1}));
  REQUIRE(orientation(x, z, y, xyz) > 0);
  CHECK(!isInSphere(x, z, y, xyz, o));
  CHECK(isInSphere(x, z, y, xyz, {1, 0, 0}));
}

TEST_CASE("a place's key tells it from all others, and its neighbours from far ones") {
  CHECK(LatticePoint{1, 0, 0}.key() == 1);
  CHECK(LatticePoint{0, 1, 0}.key() == 2);
  CHECK(LatticePoint{3, 0, 1}.key() == 0b1101);
  CHECK(kHigh.key() == (std::uint64_t{1} << 60) - 1);
}

TEST_CASE("a box alone is six tetrahedra, flat boxes too") {
  checkPoints({});
  const LatticePoint high{1000, 20, 3};
  DelaunayTetrahedra flat(kLow, high);
  checkDelaunay(flat, kLow, high);
  flat.add({500, 10, 1});
  flat.add({500, 10, 2});
  checkDelaunay(flat, kLow, high);
}

TEST_CASE("points anywhere are tetrahedralized as Delaunay says") {
  Noise noise;
  std::vector<LatticePoint> points;
  for (int i = 0; i < 300; ++i) {
    const double x = noise(), y = noise(), z = noise();
    points.push_back(at({x, y, z}));
  }
  checkPoints(points);
}

TEST_CASE("grids, planes, lines and spheres, all on one sphere or one plane, are tetrahedralized as well") {
  std::vector<LatticePoint> grid, plane, line, ring;
  for (int i = 0; i < 6; ++i) {
    for (int j = 0; j < 6; ++j) {
      for (int k = 0; k < 6; ++k) grid.push_back({100000 * (i + 1), 100000 * (j + 1), 100000 * (k + 1)});
      plane.push_back({100000 * (i + 1), 100000 * (j + 1), 524287});
    }
    line.push_back({100000 * (i + 1), 100000 * (i + 1), 100000 * (i + 1)});
  }
  for (int x = -9; x <= 9; ++x) {  // whole numbers with x² + y² + z² = 81
    for (int y = -9; y <= 9; ++y) {
      for (int z = -9; z <= 9; ++z) {
        if (x * x + y * y + z * z == 81) ring.push_back({500000 + 1000 * x, 500000 + 1000 * y, 500000 + 1000 * z});
      }
    }
  }
  REQUIRE(ring.size() == 102);
  for (const auto& points : {grid, plane, line, ring}) {
    checkPoints(points);
    std::vector<LatticePoint> backwards(points.rbegin(), points.rend());
    checkPoints(backwards);
    std::vector<LatticePoint> shuffledPoints;
    for (std::size_t i = 0; i < points.size(); ++i) {
      shuffledPoints.push_back(points[shuffledPlace(static_cast<Index>(i), static_cast<Index>(points.size()))]);
    }
    checkPoints(shuffledPoints);
  }
}

TEST_CASE("points a step apart, and beside the box, are no special case") {
  std::vector<LatticePoint> points;
  for (std::int32_t i = 0; i < 3; ++i) {
    for (std::int32_t j = 0; j < 3; ++j) {
      points.push_back({1 + i, 1 + j, 1});
      points.push_back({kHigh.x - 1 - i, kHigh.y - 1, kHigh.z - 1 - j});
      points.push_back({524287 + i, 524287 + j, 524287 + i * j});
    }
  }
  checkPoints(points);
}
