// λ as a field on the Gauss map, in the methods that have it.
#include <doctest/doctest.h>

#include <cmath>

#include "geometry/surface.h"
#include "support/runs.h"
#include "support/shapes.h"
#include "support/style_runs.h"

using namespace whittle;
using namespace whittle::testing;

namespace {

struct Setup {
  std::string method = "cubic";
  double lambda = 0.4;
  const SphereField* onGaussMap = nullptr;
  Scalars perVertex = {};
  std::string regularizer = "arap";
};

Points solved(const TriangleMesh& mesh, const Setup& setup) {
  Session session;
  REQUIRE(session.load(mesh).ok());
  REQUIRE(session.select(setup.method).ok());
  REQUIRE(session.set("lambda", encoded(setup.lambda)).ok());
  REQUIRE(session.set("maxIterations", encoded(30)).ok());
  if (setup.method == "analogy") {
    REQUIRE(session.set("style", encoded(octahedronStyle())).ok());
    REQUIRE(session.set("regularizer", encoded(setup.regularizer)).ok());
  }
  if (setup.onGaussMap) REQUIRE(session.set("lambdaOnGaussMap", encoded(*setup.onGaussMap)).ok());
  if (setup.perVertex.size()) REQUIRE(session.set("lambdaPerVertex", encoded(setup.perVertex)).ok());
  REQUIRE(session.prepare().ok());
  return finish(session).positions;
}

SphereField constant(double value) { return {8, Scalars::Constant(128, value)}; }

/// 1 within 60° of y, and a waist of half.
SphereField upper() {
  SphereField field{90, Scalars::Zero(180 * 90)};
  field.values.head(180 * 30).setOnes();
  field.values.segment(180 * 30, 180).setConstant(0.5);
  return field;
}

double largestMove(const Points& a, const Points& b) { return (a - b).rowwise().norm().maxCoeff(); }

}  // namespace

TEST_CASE(
    "a field of ones is the plain solve to the bit, one of zeros leaves the mesh, a constant is a share of lambda") {
  const TriangleMesh mesh = bent(sphere(3));
  const SphereField ones = constant(1), half = constant(0.5), zeros = constant(0);
  for (const Setup& plain : {Setup{"cubic"}, Setup{"analogy", 1}, Setup{"analogy", 1, nullptr, {}, "farap"},
                             Setup{"analogy", 1, nullptr, {}, "acap"}}) {
    CAPTURE(plain.method);
    CAPTURE(plain.regularizer);
    Setup with = plain;
    with.onGaussMap = &ones;
    const Points usual = solved(mesh, plain);
    CHECK(solved(mesh, with) == usual);
    CHECK(largestMove(usual, mesh.positions) > 0.01);
    with.onGaussMap = &zeros;
    CHECK(largestMove(solved(mesh, with), mesh.positions) == 0);
    with.onGaussMap = &half;
    Setup weaker = plain;
    weaker.lambda = plain.lambda / 2;
    CHECK(solved(mesh, with) == solved(mesh, weaker));
  }
}

TEST_CASE("a field on the Gauss map is the field by vertices that it says of their normals") {
  const TriangleMesh mesh = bent(sphere(3));
  const Points normals = vertexNormals(mesh.positions, mesh.triangles);
  const SphereField field = upper();
  Setup by{"cubic", 0.4, &field};
  Setup plain{"cubic", 0.4, nullptr, Scalars(mesh.vertexCount())};
  Setup both = by;
  both.perVertex = Scalars::LinSpaced(mesh.vertexCount(), 0, 1);
  Setup product = plain;
  for (Index v = 0; v < mesh.vertexCount(); ++v) {
    const double share = field(normals.row(v).transpose());
    plain.perVertex[v] = 0.4 * share;
    product.perVertex[v] = both.perVertex[v] * share;
  }
  CHECK(largestMove(solved(mesh, by), solved(mesh, plain)) < 2e-6);
  CHECK(largestMove(solved(mesh, both), solved(mesh, product)) < 2e-6);
}

TEST_CASE("of a block, each side has what its own normal has") {
  Mat3 turn;  // about y, so that the sides want to turn and the top does not
  turn << std::cos(0.4), 0, std::sin(0.4), 0, 1, 0, -std::sin(0.4), 0, std::cos(0.4);
  TriangleMesh block = longBox(1, 6);
  block.positions = block.positions * turn.transpose();
  const SphereField field = upper();
  CHECK(largestMove(solved(block, {"cubic", 0.5}), block.positions) > 0.05);
  CHECK(largestMove(solved(block, {"cubic", 0.5, &field}), block.positions) == 0);
}
