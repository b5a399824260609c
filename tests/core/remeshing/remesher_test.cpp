#include "remeshing/remesher.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "geometry/feature_edges.h"
#include "geometry/surface.h"
#include "mesh/adjacency.h"
#include "mesh/validate.h"
#include "remeshing/clean.h"
#include "remeshing/remesh_rule.h"
#include "remeshing/transfer.h"
#include "support/cad_shapes.h"
#include "support/shapes.h"

using namespace whittle;
using namespace whittle::testing;

namespace {

DerivedMesh remeshed(const TriangleMesh& mesh, RemeshSettings settings) {
  Remesher remesher(mesh, std::move(settings));
  double done = 0;
  while (done < 1) {
    const double now = remesher.next();
    REQUIRE(now >= done);
    done = now;
  }
  return remesher.take().derived;
}

DerivedMesh remeshed(const TriangleMesh& mesh) { return remeshed(mesh, {remeshedEdge(mesh)}); }

/// A mesh with its longest side 1.
TriangleMesh unit(TriangleMesh mesh) {
  mesh.positions /= boundingBox(mesh).sizes().maxCoeff();
  return mesh;
}

/// Three pages that hang together at one edge.
TriangleMesh book() {
  TriangleMesh mesh = grid(5);
  for (const double turn : {2.1, 4.0}) {
    const TriangleMesh page = grid(5);
    const Index first = mesh.vertexCount(), faces = mesh.faceCount();
    mesh.positions.conservativeResize(first + page.vertexCount(), 3);
    mesh.positions.bottomRows(page.vertexCount()) =
        page.positions * Eigen::AngleAxisd(turn, Vec3::UnitY()).toRotationMatrix().transpose();
    mesh.triangles.conservativeResize(faces + page.faceCount(), 3);
    for (Index f = 0; f < page.faceCount(); ++f) {
      for (int k = 0; k < 3; ++k) {
        const Index v = page.triangles(f, k);
        mesh.triangles(faces + f, k) = v % 5 == 0 ? v : first + v;
      }
    }
  }
  return mesh;
}

/// Two fans of faces with one vertex in common.
TriangleMesh bowTie() {
  TriangleMesh mesh = together(grid(4), grid(4), {1, 1, 0});
  for (Index corner = 0; corner < mesh.triangles.size(); ++corner) {
    if (mesh.triangles.data()[corner] == 16) mesh.triangles.data()[corner] = 15;
  }
  return mesh;
}

/// Shapes, turned so that nothing is special about the axes, and what becomes of them.
struct Example {
  std::string name;
  TriangleMesh mesh;
  DerivedMesh derived;
};

const std::vector<Example>& examples() {
  static const std::vector<Example> examples = [] {
    std::vector<Example> examples;
    for (auto& [name, mesh] : std::vector<std::pair<std::string, TriangleMesh>>{
             {"plate, 12", drilledPlate(5, .05, 12, .06)},
             {"plate, 32", drilledPlate(3, .06, 32, .06)},
             {"plate, 128", drilledPlate(5, .05, 128, .03)},
             {"bracket", filletedBracket(.08, .1, 12)},
             {"thin bracket", filletedBracket(.02, .02, 6)},
             {"mug", unit(mug(64))},
             {"rod, 6", unit(prism(6, .3))},
             {"rod, 24", unit(prism(24, .3))},
             {"box", longBox(1, 1)},
             {"long box", unit(longBox(9, 1))},
             {"cone", unit(revolved({{{0, 0}}, {{.4, 0}}, {{0, 1}}}, 40, false))},
             {"torus", unit(torus(20))},
             {"animal", unit(animal(4))},
             {"strip", unit(moebiusStrip(40))},
             {"grid", grid(3)},
             {"book", unit(book())},
             {"bow-tie", unit(bowTie())},
             {"touching", unit(together(longBox(1, 1), longBox(2, 1), {0, 0, 1}))},
         }) {
      mesh.positions = (mesh.positions * someRotation().transpose()).eval();
      examples.push_back({name, mesh, remeshed(mesh)});
    }
    return examples;
  }();
  return examples;
}

double volume(const TriangleMesh& mesh) {
  double sum = 0;
  for (Index f = 0; f < mesh.faceCount(); ++f) {
    const auto corner = [&](int k) -> Vec3 { return mesh.positions.row(mesh.triangles(f, k)).transpose(); };
    sum += corner(0).dot(corner(1).cross(corner(2))) / 6;
  }
  return sum;
}

Index euler(const TriangleMesh& mesh) {
  std::vector<bool> isUsed(mesh.vertexCount(), false);
  for (Index corner = 0; corner < mesh.triangles.size(); ++corner) isUsed[mesh.triangles.data()[corner]] = true;
  return static_cast<Index>(std::count(isUsed.begin(), isUsed.end(), true)) -
         MeshEdges(mesh.triangles, mesh.vertexCount()).count() + mesh.faceCount();
}

struct Segment {
  Vec3 from, to;

  double distance(const Vec3& p) const {
    const Vec3 way = to - from;
    return (p - from - std::clamp((p - from).dot(way) / way.squaredNorm(), 0.0, 1.0) * way).norm();
  }
};

/// Features, borders and edges of three and more faces.
std::vector<Segment> creases(const TriangleMesh& mesh, double degrees) {
  const MeshEdges edges(mesh.triangles, mesh.vertexCount());
  const std::vector<bool> features =
      featureEdges(facePairs(mesh.positions, mesh.triangles, edges), edges.count(), degrees * EIGEN_PI / 180);
  std::vector<Segment> segments;
  for (Index e = 0; e < edges.count(); ++e) {
    if (!features[e] && edges.faceCountAt(e) == 2) continue;
    const auto [a, b] = edges.ends[e];
    segments.push_back({mesh.positions.row(a).transpose(), mesh.positions.row(b).transpose()});
  }
  return segments;
}

/// The farthest that points on some segments are from others.
double farthest(const std::vector<Segment>& from, const std::vector<Segment>& to) {
  double most = 0;
  for (const Segment& segment : from) {
    for (const double share : {0.0, 0.37, 0.5, 1.0}) {
      double least = std::numeric_limits<double>::infinity();
      const Vec3 point = (1 - share) * segment.from + share * segment.to;
      for (const Segment& other : to) least = std::min(least, other.distance(point));
      most = std::max(most, least);
    }
  }
  return most;
}

}  // namespace

TEST_CASE("faces come out even, well shaped and as they hung together") {
  for (const auto& [label, mesh, derived] : examples()) {
    const auto& name = label;
    CAPTURE(name);
    const TriangleMesh& result = derived.mesh;
    REQUIRE(validate(result).ok());
    const double edge = remeshedEdge(mesh);
    const Scalars areas = faceAreas(result.positions, result.triangles);
    CHECK(areas.sum() == doctest::Approx(faceAreas(mesh.positions, mesh.triangles).sum()).epsilon(0.02));
    CHECK(volume(result) == doctest::Approx(volume(mesh)).epsilon(0.03));
    double poor = 0;
    for (Index f = 0; f < result.faceCount(); ++f) {
      CHECK(thickness(result, f) > kSliver);
      const auto corner = [&](int k) -> Vec3 { return result.positions.row(result.triangles(f, k)).transpose(); };
      if (triangleQuality(corner(0), corner(1), corner(2)) < 0.1) poor += areas[f];
    }
    CHECK(poor < 0.003 * areas.sum());
    const MeshEdges edges(result.triangles, result.vertexCount());
    std::vector<double> lengths;
    for (const auto& [a, b] : edges.ends) lengths.push_back((result.positions.row(a) - result.positions.row(b)).norm());
    std::sort(lengths.begin(), lengths.end());
    CHECK(lengths.back() < 5 * lengths[lengths.size() / 2]);
    CHECK(lengths.back() < 1.6 * edge);

    CHECK(euler(result) == euler(mesh));
    CHECK(inspect(result).components == inspect(mesh).components);
    CHECK(needsRemeshing(result) == RemeshCause::none);
  }
}

TEST_CASE("the same mesh gives the same bits") {
  const TriangleMesh mesh = unit(bowTie());
  const DerivedMesh first = remeshed(mesh), second = remeshed(mesh);
  CHECK(first.mesh.triangles == second.mesh.triangles);
  CHECK(first.mesh.positions == second.mesh.positions);
  CHECK(first.faceOrigin == second.faceOrigin);
}

TEST_CASE("no faces are folded, and what was smooth has no new creases") {
  for (const auto& [label, mesh, derived] : examples()) {
    const auto& name = label;
    CAPTURE(name);
    const TriangleMesh result = remeshed(mesh).mesh;
    if (name == "cone") continue;  // whose tip is sharper the fewer faces meet there
    const std::vector<Segment> before = creases(mesh, 35), sharp = creases(result, 40);
    CHECK(farthest(sharp, before) < 1e-3);
  }
}

TEST_CASE("creases, borders and seams stay where they are, to a thousandth") {
  for (const auto& [label, mesh, derived] : examples()) {
    const auto& name = label;
    CAPTURE(name);
    CHECK(farthest(creases(mesh, 36), creases(derived.mesh, 30)) < 1e-3);
  }
}

TEST_CASE("the surface stays where it is, and parts and origins are known") {
  for (const auto& [label, mesh, derived] : examples()) {
    const auto& name = label;
    CAPTURE(name);
    for (Index v = 0; v < derived.mesh.vertexCount(); ++v) {
      if (derived.vertexOrigin[v] < 0) continue;
      CHECK(derived.mesh.positions.row(v) == mesh.positions.row(derived.vertexOrigin[v]));
    }
    const Components parts = connectedComponents(mesh.triangles, mesh.vertexCount()),
                     made = connectedComponents(derived.mesh.triangles, derived.mesh.vertexCount());
    std::vector<Index> partOf(made.count, -1);
    for (Index f = 0; f < derived.mesh.faceCount(); ++f) {
      Index& part = partOf[made.ofVertex[derived.mesh.triangles(f, 0)]];
      const Index own = parts.ofVertex[mesh.triangles(derived.faceOrigin[f], 0)];
      CHECK((part < 0 || part == own));
      part = own;
    }
    Transfer transfer(mesh, derived);
    while (transfer.next() < 1) {
    }
    for (Index v = 0; v < mesh.vertexCount(); ++v) {
      const Transfer::Place& place = transfer.place(v);
      if (place.face < 0) continue;
      Vec3 point = Vec3::Zero();
      for (int k = 0; k < 3; ++k) {
        point += place.weights[k] * derived.mesh.positions.row(derived.mesh.triangles(place.face, k)).transpose();
      }
      CHECK((point - mesh.positions.row(v).transpose()).norm() < 0.009);
    }
  }
}

TEST_CASE("walls of slivers are cut into faces that are none, unless they are next to nothing") {
  for (const double thin : {5e-4, 1e-5}) {
    TriangleMesh plate = longBox(1, 1);
    plate.positions *= Vec3(1, .8, thin).asDiagonal();
    REQUIRE(clean(plate).unmended.size() == 8);
    Remesher remesher(plate, {0.04});
    while (remesher.next() < 1) {
    }
    CHECK(remesher.take().unmended.empty() == (thin > 1e-4));
  }
}

TEST_CASE("a narrow fillet keeps enough faces around") {
  const TriangleMesh bracket = filletedBracket(.05, .03, 8);
  const TriangleMesh result = remeshed(bracket, {0.04}).mesh;
  const MeshEdges edges(result.triangles, result.vertexCount());
  int bends = 0;
  for (const FacePair& pair : facePairs(result.positions, result.triangles, edges)) {
    const double degrees = pair.angle * 180 / EIGEN_PI;
    CHECK((degrees < 37 || degrees > 50));
    bends += degrees > 10 && degrees < 37;
  }
  CHECK(bends > 60);
}

TEST_CASE("creases can be marked and unmarked by hand") {
  const TriangleMesh mesh = grid(5);  // a line across what is flat
  const std::vector<std::array<Index, 2>> middle = {{10, 11}, {12, 11}, {12, 13}, {13, 14}};
  const TriangleMesh result = remeshed(mesh, {0.06, 35, middle}).mesh;
  const MeshEdges edges(result.triangles, result.vertexCount());
  double length = 0;
  for (const auto& [a, b] : edges.ends) {
    if (std::abs(result.positions(a, 1) - .5) + std::abs(result.positions(b, 1) - .5) > 1e-12) continue;
    length += std::abs(result.positions(a, 0) - result.positions(b, 0));
  }
  CHECK(length == doctest::Approx(1));

  // Without its mark the edge of a box is nothing that vertices keep to.
  std::vector<std::array<Index, 2>> edge;
  const auto isOn = [&](const TriangleMesh& on, Index v) {
    return on.positions(v, 0) == 1 && on.positions(v, 1) > 0.9999;
  };
  const TriangleMesh cube = longBox(4, 4);
  const MeshEdges cubeEdges(cube.triangles, cube.vertexCount());
  for (const auto& ends : cubeEdges.ends) {
    if (isOn(cube, ends[0]) && isOn(cube, ends[1])) edge.push_back(ends);
  }
  REQUIRE(edge.size() == 4);
  const auto countOn = [&](const TriangleMesh& on) {
    int count = 0;
    for (Index v = 0; v < on.vertexCount(); ++v) count += isOn(on, v);
    return count;
  };
  CHECK(countOn(remeshed(cube, {0.05}).mesh) > 15);
  CHECK(countOn(remeshed(cube, {0.05, 35, {}, edge}).mesh) < 12);
}
