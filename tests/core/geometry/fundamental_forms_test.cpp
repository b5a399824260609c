#include "geometry/fundamental_forms.h"

#include <doctest/doctest.h>

#include <cmath>

#include "support/shapes.h"

using namespace whittle;
using namespace whittle::testing;

namespace {

/// A mesh whose forms are asked for in one shape after the other.
struct Sheet {
  TriangleMesh mesh;
  std::vector<FaceHinges> hinges = faceHinges(mesh.triangles, MeshEdges(mesh.triangles, mesh.vertexCount()));
  std::vector<FaceFrame> frames;
  std::vector<FaceTilt> tilts;

  explicit Sheet(TriangleMesh rest) : mesh(std::move(rest)) {
    for (Index f = 0; f < mesh.faceCount(); ++f) {
      std::array<Vec3, 3> corners;
      for (int k = 0; k < 3; ++k) corners[k] = mesh.positions.row(mesh.triangles(f, k));
      frames.push_back(FaceFrame::of(corners));
    }
    findTilts(mesh.positions, mesh.triangles, tilts);
  }

  FormsInput input() const { return {mesh.positions, mesh.triangles, hinges, tilts}; }
  FaceForms forms(Index face) const { return formsOf(input(), frames[face], face); }
  void move(Index vertex, int axis, double by) {
    mesh.positions(vertex, axis) += by;
    findTilts(mesh.positions, mesh.triangles, tilts);
  }
};

/// Three faces on one edge.
TriangleMesh threeWings() {
  TriangleMesh mesh;
  mesh.positions.resize(5, 3);
  mesh.positions << 0, 0, 0, 1, 0.1, 0, 0.4, 1, 0.2, 0.5, -0.9, 0.3, 0.6, 0.1, 1.1;
  mesh.triangles.resize(3, 3);
  mesh.triangles << 0, 1, 2, 1, 0, 3, 0, 1, 4;
  return mesh;
}

/// Two faces that lie all but on each other.
TriangleMesh foldedPair() {
  TriangleMesh mesh;
  mesh.positions.resize(4, 3);
  mesh.positions << 0, 0, 0, 1, 0, 0, 0.4, 1, 0, 0.5, 0.9, 0.03;
  mesh.triangles.resize(2, 3);
  mesh.triangles << 0, 1, 2, 1, 0, 3;
  return mesh;
}

/// The largest difference between the derivatives of the rises and differences of them, as a share of the largest.
double worstGradientError(Sheet sheet) {
  constexpr double kStep = 1e-5;
  double worst = 0, largest = 0;
  for (Index f = 0; f < sheet.mesh.faceCount(); ++f) {
    for (int k = 0; k < 3; ++k) {
      const FaceHinge hinge = sheet.hinges[f][k];
      if (hinge.face < 0) continue;
      const RiseGradient gradient = riseGradient(sheet.input(), sheet.forms(f), f, k);
      for (int a = 0; a < 4; ++a) {
        const Index vertex = a < 3 ? sheet.mesh.triangles(f, a) : sheet.mesh.triangles(hinge.face, hinge.opposite);
        const Vec3& slope = a < 3 ? gradient.corners[a] : gradient.across;
        for (int axis = 0; axis < 3; ++axis) {
          Sheet forward = sheet, back = sheet;
          forward.move(vertex, axis, kStep);
          back.move(vertex, axis, -kStep);
          const double difference = (forward.forms(f).rises[k].height - back.forms(f).rises[k].height) / (2 * kStep);
          worst = std::max(worst, std::abs(difference - slope[axis]));
          largest = std::max(largest, std::abs(difference));
        }
      }
    }
  }
  return worst / largest;
}

}  // namespace

TEST_CASE("the first form is the identity at rest and says how far a face was stretched") {
  const TriangleMesh mesh = bent(sphere(1));
  const Sheet rest(mesh);
  Sheet stretched(mesh);
  const Mat3 turned = someRotation() * Vec3(1.5, 1.5, 1.5).asDiagonal();
  stretched.mesh.positions = mesh.positions * turned.transpose();
  findTilts(stretched.mesh.positions, mesh.triangles, stretched.tilts);
  for (Index f = 0; f < mesh.faceCount(); ++f) {
    CHECK((rest.forms(f).first - Mat2::Identity()).norm() < 1e-13);
    CHECK((stretched.forms(f).first - 2.25 * Mat2::Identity()).norm() < 1e-12);
    // Curvature is by the frame at rest: b becomes as much larger as the mesh.
    CHECK((stretched.forms(f).second - 1.5 * rest.forms(f).second).norm() < 1e-11);
  }
}

TEST_CASE("the second form is that of the sphere, of one sign all over, and nothing on a plane") {
  const Sheet ball(sphere(3));
  double mean = 0;
  for (Index f = 0; f < ball.mesh.faceCount(); ++f) mean += ball.forms(f).second.trace() / 2 / ball.mesh.faceCount();
  CHECK(std::abs(std::abs(mean) - 1) < 0.05);
  for (Index f = 0; f < ball.mesh.faceCount(); ++f) {
    CHECK(ball.forms(f).second.trace() / 2 / mean > 0.7);
    CHECK(ball.forms(f).second.trace() / 2 / mean < 1.3);
  }
  const Sheet plane(grid(5));
  for (Index f = 0; f < plane.mesh.faceCount(); ++f) CHECK(plane.forms(f).second.norm() < 1e-12);
}

TEST_CASE("derivatives of the second form are those of differences") {
  CHECK(worstGradientError(Sheet(bent(sphere(1)))) < 1e-8);
  CHECK(worstGradientError(Sheet(bent(grid(4)))) < 1e-8);
  CHECK(worstGradientError(Sheet(bent(moebiusStrip(9)))) < 1e-8);
  CHECK(worstGradientError(Sheet(threeWings())) < 1e-8);
  CHECK(worstGradientError(Sheet(foldedPair())) < 1e-8);
}

TEST_CASE("a border has nothing across, and every face of a crowded edge has a neighbour") {
  const Sheet wings(threeWings());
  for (Index f = 0; f < 3; ++f) {
    const FaceHinge& shared = wings.hinges[f][2];
    CHECK(shared.face == (f + 1) % 3);
    CHECK(shared.sign == (f == 2 ? -1 : 1));  // the first and the last run along it the same way
    CHECK(wings.hinges[f][0].face < 0);
    CHECK(wings.forms(f).rises[0].height == 0);
  }
}
