#include <doctest/doctest.h>

#include <cmath>

#include "geometry/surface.h"
#include "support/allocations.h"
#include "support/shapes.h"
#include "targets/gauss_map.h"

using namespace whittle;
using namespace whittle::testing;

namespace {

using Kind = GaussMapData::Kind;

std::vector<Vec3> directions(int count) {
  Noise noise;
  std::vector<Vec3> result;
  for (int i = 0; i < count; ++i) result.push_back(noise.direction());
  return result;
}

double degreesBetween(const Vec3& a, const Vec3& b) { return std::atan2(a.cross(b).norm(), a.dot(b)) * 180 / EIGEN_PI; }

/// The sphere with its own normals.
GaussMapData identityOn(const TriangleMesh& mesh, Kind kind) {
  return {kind, kind == Kind::perVertex ? mesh.positions : faceNormals(mesh.positions, mesh.triangles), mesh.positions,
          mesh.triangles};
}

/// Most of the sphere's triangles crushed towards a pole, as the flow does with ears.
TriangleMesh crushed(TriangleMesh mesh) {
  for (Index v = 0; v < mesh.vertexCount(); ++v) {
    const Vec3 p = mesh.positions.row(v).transpose();
    mesh.positions.row(v) = Vec3(0.001 * p.x(), 0.001 * p.y(), p.z() > -0.9 ? 0.001 + 0.002 * p.z() : 0.01 * p.z())
                                .normalized()
                                .transpose();
  }
  return mesh;
}

}  // namespace

TEST_CASE("closest: the nearest of the list but for the turn that decides ties, whatever its length") {
  const std::vector<Vec3> queries = directions(3000), others = directions(5000);
  for (const Index count : {1, 2, 6, 12, 260, 2000}) {
    Points normals(count, 3);
    for (Index i = 0; i < count; ++i) normals.row(i) = others[3000 + i].transpose();
    const GaussMap map({Kind::closest, normals});
    for (const Vec3& n : queries) {
      const Vec3 target = map(3 * n);
      REQUIRE(target.norm() == doctest::Approx(1));
      // Both the direction and its distance to the nearest change by the turn of 1e-3 radians at most.
      REQUIRE(std::acos(target.dot(n)) <= std::acos((normals * n).maxCoeff()) + 2e-3);
    }
  }
}

TEST_CASE("closest: rounding does not decide between two directions, and opposite normals take opposite ones") {
  Points cube(6, 3);
  cube << Mat3::Identity(), -Mat3::Identity();
  for (const Mat3& turn : {Mat3(Mat3::Identity()), someRotation()}) {
    const GaussMap map({Kind::closest, cube * turn.transpose()});
    Noise noise;
    for (const Vec3& tie :
         {Vec3(1, 1, 0), Vec3(1, -1, 0), Vec3(0, 1, 1), Vec3(1, 0, -1), Vec3(1, 1, 1), Vec3(-1, 1, 1)}) {
      const Vec3 n = turn * tie.normalized(), target = map(n);
      CHECK((map(-n) + target).norm() < 1e-12);
      for (int trial = 0; trial < 50; ++trial) {
        const Vec3 noisy = n + 1e-5 * noise.direction();
        REQUIRE(map(noisy) == target);
      }
      // Nor does the order of the list.
      CHECK(GaussMap({Kind::closest, (cube * turn.transpose()).colwise().reverse()})(n) == target);
    }
  }
}

TEST_CASE("the identity on a sphere: exact at its points, nearly so between") {
  const TriangleMesh mesh = sphere(5);
  const GaussMap perVertex(identityOn(mesh, Kind::perVertex)), perFace(identityOn(mesh, Kind::perFace));
  double vertexError = 0, faceError = 0;
  for (const Vec3& n : directions(5000)) {
    vertexError = std::max(vertexError, degreesBetween(perVertex(n), n));
    faceError = std::max(faceError, degreesBetween(perFace(n), n));
  }
  CHECK(vertexError < 1e-5);  // the central projection of a point on a triangle is the point itself
  CHECK(faceError < 3.5);
  for (Index v = 0; v < mesh.vertexCount(); ++v) {
    const Vec3 n = mesh.positions.row(v).transpose();
    REQUIRE((perVertex(n) - n).norm() < 1e-12);
  }
  // As a style mesh comes, with the normals of its surface.
  const TriangleMesh coarse = sphere(4);
  const GaussMap computed(
      {Kind::perVertex, vertexNormals(coarse.positions, coarse.triangles), coarse.positions, coarse.triangles});
  double sum = 0;
  for (const Vec3& n : directions(2000)) sum += degreesBetween(computed(n), n);
  CHECK(sum / 2000 < 0.6);  // an octahedral sphere is uneven at its six corners
}

TEST_CASE("crushed triangles are found as well") {
  const TriangleMesh round = sphere(4);
  const TriangleMesh mesh = crushed(round);
  // Every point carries where it was: the middle of a triangle must come back as a mean of its corners.
  const GaussMap map({Kind::perVertex, round.positions, mesh.positions, mesh.triangles});
  for (Index f = 0; f < mesh.faceCount(); ++f) {
    Vec3 place = Vec3::Zero(), mean = Vec3::Zero();
    for (int k = 0; k < 3; ++k) {
      place += mesh.positions.row(mesh.triangles(f, k)).transpose();
      mean += round.positions.row(mesh.triangles(f, k)).transpose();
    }
    Mat3 corners;
    for (int k = 0; k < 3; ++k) corners.col(k) = mesh.positions.row(mesh.triangles(f, k)).transpose();
    if (corners.determinant() < 1e-12) continue;  // turned over or flat by the crushing
    CHECK(degreesBetween(map(place), mean) < 0.01);
  }
}

TEST_CASE("gaps have the nearest triangle's normal") {
  TriangleMesh mesh = sphere(3);
  mesh.triangles = mesh.triangles.topRows(1).eval();  // one small triangle for all directions
  const GaussMap map(identityOn(mesh, Kind::perVertex));
  for (const Vec3& n : directions(500)) REQUIRE(map(n).norm() == doctest::Approx(1));

  TriangleMesh half = sphere(4);
  Index kept = 0;
  for (Index f = 0; f < half.faceCount(); ++f) {
    if (half.positions(half.triangles(f, 0), 2) < 0) continue;
    half.triangles.row(kept++) = half.triangles.row(f).eval();
  }
  half.triangles.conservativeResize(kept, 3);
  const GaussMap open(identityOn(half, Kind::perVertex));
  for (const Vec3& n : directions(500)) {
    if (n.z() > -0.25 && n.z() < -0.05) CHECK(degreesBetween(open(n), n) < 25);
  }
}

TEST_CASE("opposite corners and zero normals have an answer, and lookups allocate nothing") {
  TriangleMesh mesh = sphere(0);
  GaussMapData data{Kind::perVertex, mesh.positions, mesh.positions, mesh.triangles};
  for (Index v = 0; v < 6; ++v) data.normals.row(v) << 0, 0, v % 2 ? 1 : -1;
  const GaussMap map(data);
  const long before = allocationCount();
  CHECK(map(Vec3(0.5, 0, 0.5)).norm() == doctest::Approx(1));
  CHECK(map(Vec3::Zero()) == Vec3::Zero());
  CHECK(allocationCount() == before);
}

TEST_CASE("what is no Gauss map is refused with a sentence") {
  const TriangleMesh mesh = sphere(1);
  const GaussMapData good = identityOn(mesh, Kind::perVertex);
  CHECK(validateGaussMap(good).ok());
  CHECK(validateGaussMap(identityOn(mesh, Kind::perFace)).ok());
  const auto messageOf = [&](auto change) {
    GaussMapData data = good;
    change(data);
    const Status status = validateGaussMap(data);
    CHECK(status.code == Code::badParameter);
    return status.numbered(status.element.index).message;
  };
  CHECK(messageOf([](GaussMapData& d) { d.normals.resize(0, 3); }).find("no normals") != std::string::npos);
  CHECK(messageOf([](GaussMapData& d) { d.normals.row(4).setZero(); }).find("normal 4") != std::string::npos);
  CHECK(messageOf([](GaussMapData& d) { d.points(3, 1) = NAN; }).find("point 3") != std::string::npos);
  CHECK(messageOf([](GaussMapData& d) { d.triangles(2, 1) = 18; }).find("not there") != std::string::npos);
  CHECK(messageOf([](GaussMapData& d) { d.triangles.resize(0, 3); }).find("no triangles") != std::string::npos);
  CHECK(messageOf([](GaussMapData& d) { d.kind = Kind::perFace; }).find("each triangle") != std::string::npos);
  CHECK(messageOf([](GaussMapData& d) { d.normals.conservativeResize(5, 3); }).find("each point") != std::string::npos);
}
