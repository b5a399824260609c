// The styles of `cubic` beyond the plain cube: weights on each axis, any matrix B, orientations and frames.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/surface.h"
#include "support/allocations.h"
#include "support/shapes.h"
#include "support/style_runs.h"

using namespace whittle;
using namespace whittle::testing;

namespace {

/// How far single-precision rotations may take the same shape along two ways, for meshes of size about 2.
constexpr double kSingle = 5e-5;

struct Style {
  double lambda = 0.5;
  Vec3 axes = Vec3::Ones();
  std::string polyhedron = "cube";
  Scalars rows = {};  // in its place
  Scalars orientation = Eigen::Vector4d(0, 0, 0, 1);
  Scalars frames = {};
  std::string localStep = "exact";
  std::string acceleration = "nesterov";
  int maxIterations = 40;
};

void configure(Session& session, const Style& style) {
  REQUIRE(session.select("cubic").ok());
  REQUIRE(session.set("lambda", encoded(style.lambda)).ok());
  REQUIRE(session.set("lambdaAxes", encoded(style.axes)).ok());
  REQUIRE(session.set("polyhedron", style.rows.size() ? encoded(style.rows) : encoded(style.polyhedron)).ok());
  REQUIRE(session.set("orientation", encoded(style.orientation)).ok());
  REQUIRE(session.set("frames", encoded(style.frames)).ok());
  REQUIRE(session.set("localStep", encoded(style.localStep)).ok());
  REQUIRE(session.set("acceleration", encoded(style.acceleration)).ok());
  REQUIRE(session.set("tolerance", encoded(0)).ok());
  REQUIRE(session.set("maxIterations", encoded(style.maxIterations)).ok());
}

Run run(const TriangleMesh& mesh, const Style& style) {
  Session session;
  REQUIRE(session.load(mesh).ok());
  configure(session, style);
  REQUIRE(session.prepare().ok());
  return finish(session);
}

/// x y z w of a rotation, of some other length.
Scalars quaternionOf(const Mat3& R, double length = 1) { return length * Eigen::Quaterniond(R).coeffs(); }

TriangleMesh turned(TriangleMesh mesh, const Mat3& R) {
  mesh.positions = (mesh.positions * R.transpose()).eval();
  return mesh;
}

double largestMove(const Points& a, const Points& b) { return (a - b).rowwise().norm().maxCoeff(); }

/// Two frames, one above the other, and a strip between them that has none.
Scalars framesAcross(const TriangleMesh& mesh, const Mat3& lower, const Mat3& upper) {
  Scalars frames = Scalars::Zero(4 * mesh.vertexCount());
  for (Index v = 0; v < mesh.vertexCount(); ++v) {
    const double y = mesh.positions(v, 1);
    if (std::abs(y) > 0.2) frames.segment<4>(4 * v) = quaternionOf(y < 0 ? lower : upper, 1.5);
  }
  return frames;
}

Scalars someRows() {
  Scalars rows(15);
  rows << 1, 0, 0, 0.3, 0.8, -0.2, 0, 0.1, 0.5, -0.6, 0.4, 0.9, 1, 1, 1;
  return rows;
}

/// Styles that have nothing in common.
std::vector<Style> awkwardStyles(const TriangleMesh& mesh) {
  const Mat3 R = someRotation();
  std::vector<Style> styles(6);
  styles[0].axes = {1, 1, 0.1};
  styles[1].axes = {0, 0, 1.5};
  styles[2].orientation = quaternionOf(R);
  styles[3].frames = framesAcross(mesh, R, R * R);
  styles[3].axes = {1, 0, 2};
  styles[4].rows = someRows();
  styles[5].rows = someRows().head(6);
  styles[5].frames = framesAcross(mesh, R, Mat3::Identity());
  return styles;
}

/// Mean size of the normals' part along an axis, area-weighted.
double meanAlong(const Vec3& axis, const Points& positions, const Triangles& triangles) {
  const Scalars areas = faceAreas(positions, triangles);
  return areas.dot((faceNormals(positions, triangles) * axis).cwiseAbs()) / areas.sum();
}

}  // namespace

TEST_CASE("an orientation is as good as turning the mesh, in all styles and by both local steps") {
  const TriangleMesh mesh = bent(sphere(3));
  const Mat3 R = someRotation();
  for (const char* localStep : {"exact", "admm"}) {
    for (Style style : {Style{}, Style{0.5, {1, 0.4, 0}}, Style{0.5, Vec3::Ones(), "hexagonal-prism"},
                        Style{0.5, Vec3::Ones(), "cube", someRows()}}) {
      style.localStep = localStep;
      const Points plain = run(turned(mesh, R.transpose()), style).positions * R.transpose();
      style.orientation = quaternionOf(R, 0.01);
      CHECK(largestMove(run(mesh, style).positions, plain) < kSingle);
    }
  }
}

TEST_CASE("a cube turned onto itself changes nothing, one with a longer side does") {
  const TriangleMesh mesh = bent(sphere(3));
  const Mat3 quarter = Eigen::AngleAxisd(EIGEN_PI / 2, Vec3::UnitZ()).toRotationMatrix();
  const Style cube{0.5, Vec3::Ones()}, box{0.5, {1, 0.2, 1}};
  Style turnedCube = cube, turnedBox = box, fittingBox = box;
  turnedCube.orientation = turnedBox.orientation = fittingBox.orientation = quaternionOf(quarter);
  fittingBox.axes = {0.2, 1, 1};
  CHECK(largestMove(run(mesh, turnedCube).positions, run(mesh, cube).positions) < kSingle);
  CHECK(largestMove(run(mesh, turnedBox).positions, run(mesh, box).positions) > 0.01);
  CHECK(largestMove(run(mesh, fittingBox).positions, run(mesh, box).positions) < kSingle);
}

TEST_CASE("frames of one orientation are that orientation, to the bit; so are frames that say nothing") {
  const TriangleMesh mesh = bent(sphere(3));
  Style style;
  style.orientation = quaternionOf(someRotation());
  const Run whole = run(mesh, style);
  style.frames = Scalars::Zero(4 * mesh.vertexCount());
  CHECK(run(mesh, style).positions == whole.positions);
  style.frames = style.orientation.replicate(mesh.vertexCount(), 1);
  style.orientation = Eigen::Vector4d(0, 1, 0, 0);
  CHECK(run(mesh, style).positions == whole.positions);
}

TEST_CASE("each region takes on the cube of its own frame") {
  const TriangleMesh mesh = together(sphere(4), sphere(4), {3, 0, 0});
  const Index half = mesh.vertexCount() / 2;
  const Mat3 R = Eigen::AngleAxisd(EIGEN_PI / 4, Vec3::UnitY()).toRotationMatrix();
  Style style{0.5};
  style.frames = Scalars::Zero(4 * mesh.vertexCount());
  for (Index v = half; v < mesh.vertexCount(); ++v) style.frames.segment<4>(4 * v) = quaternionOf(R);
  const Points positions = run(mesh, style).positions;
  const Points upright = run(mesh, Style{0.5}).positions;
  const Points second = upright.bottomRows(half).rowwise() - Eigen::RowVector3d(3, 0, 0);
  CHECK(largestMove(positions.topRows(half), upright.topRows(half)) < kSingle);
  // A subdivided octahedron looks another way to a turned cube: alike, not equal.
  const auto reach = [](const Points& points, const Vec3& axis) { return (points * axis).cwiseAbs().maxCoeff(); };
  const Points moved = positions.bottomRows(half).rowwise() - Eigen::RowVector3d(3, 0, 0);
  CHECK(reach(moved, R * Vec3::UnitX()) == doctest::Approx(reach(second, Vec3::UnitX())).epsilon(0.03));
  CHECK(reach(moved, Vec3::UnitX()) > 1.2 * reach(second, Vec3::UnitX()));
}

TEST_CASE("weights of 1, no turn and B = I are the default, to the bit") {
  const TriangleMesh mesh = bent(sphere(3));
  Session session;
  REQUIRE(session.load(mesh).ok());
  REQUIRE(session.select("cubic").ok());
  REQUIRE(session.set("lambda", encoded(0.5)).ok());
  REQUIRE(session.set("tolerance", encoded(0)).ok());
  REQUIRE(session.set("maxIterations", encoded(40)).ok());
  REQUIRE(session.prepare().ok());
  const Run plain = finish(session);
  Style style;
  CHECK(run(mesh, style).positions == plain.positions);
  style.orientation = Eigen::Vector4d(0, 0, 0, -3);
  style.frames = style.orientation.replicate(mesh.vertexCount(), 1);
  CHECK(run(mesh, style).positions == plain.positions);
  style.rows = Scalars::Zero(9);
  for (Index k : {0, 4, 8}) style.rows[k] = 1;
  CHECK(largestMove(run(mesh, style).positions, plain.positions) < kSingle);
}

/// What single precision leaves of energies.
constexpr double kEnergyRounding = 1e-7;

TEST_CASE("energy never rises, the same bits twice, nothing claimed on the way, whatever the style") {
  const TriangleMesh mesh = bent(sphere(3));
  for (Style style : awkwardStyles(mesh)) {
    for (const char* localStep : {"exact", "admm"}) {
      for (const char* acceleration : {"nesterov", "none"}) {
        style.localStep = localStep;
        style.acceleration = acceleration;
        Session session;
        REQUIRE(session.load(mesh).ok());
        configure(session, style);
        REQUIRE(session.prepare().ok());
        StepReport report;
        double before = std::numeric_limits<double>::infinity();
        const long claimed = allocationCount();
        do {
          REQUIRE(session.step(report).ok());
          REQUIRE(report.energy <= before * (1 + kEnergyRounding));
          before = report.energy;
        } while (report.outcome == Outcome::running);
        CHECK(allocationCount() == claimed);
        Points positions(mesh.vertexCount(), 3);
        session.copyPositions(positions.data());
        CHECK(run(mesh, style).positions == positions);
      }
    }
  }
}

TEST_CASE("without cubeness the mesh comes back from any frame, to the bit") {
  const TriangleMesh mesh = bent(sphere(3));
  for (Style style : awkwardStyles(mesh)) {
    style.lambda = 0;
    CHECK(run(mesh, style).positions == mesh.positions);
  }
  Style style;
  style.axes.setZero();
  style.orientation = quaternionOf(someRotation());
  for (const char* localStep : {"exact", "admm"}) {
    style.localStep = localStep;
    CHECK(largestMove(run(mesh, style).positions, mesh.positions) < kSingle);
  }
}

TEST_CASE("one axis alone makes beams along it, a small one plates across it") {
  const TriangleMesh mesh = sphere(4);
  const double before = meanAlong(Vec3::UnitZ(), mesh.positions, mesh.triangles);
  const auto along = [&](const Vec3& axes, const Vec3& axis) {
    return meanAlong(axis, run(mesh, Style{0.5, axes}).positions, mesh.triangles);
  };
  CHECK(along({0, 0, 1}, Vec3::UnitZ()) < 0.6 * before);
  CHECK(along({1, 1, 0.1}, Vec3::UnitZ()) > 1.2 * before);
  CHECK(along({1, 1, 0.1}, Vec3::UnitX()) < along(Vec3::Ones(), Vec3::UnitX()));
}

TEST_CASE("what cannot be a style is refused by name, and nothing of it stays") {
  const TriangleMesh mesh = sphere(2);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  Session session;
  REQUIRE(session.load(mesh).ok());
  REQUIRE(session.select("cubic").ok());
  const auto refuses = [&](const char* parameter, const Scalars& values, const char* what) {
    const Status status = session.set(parameter, encoded(values));
    CHECK(status.code == Code::badParameter);
    CHECK(status.message.find(parameter) != std::string::npos);
    CHECK(status.message.find(what) != std::string::npos);
    return status.element.index;
  };
  for (const Vec3& axes : {Vec3(1, 1, -0.1), Vec3(101, 1, 1), Vec3(1, nan, 1)})
    refuses("lambdaAxes", axes, "out of its range");
  refuses("lambdaAxes", Scalars::Ones(2), "needs 3");
  refuses("orientation", Scalars::Zero(4), "not all of them zero");
  refuses("orientation", Scalars::Ones(3), "quaternion");
  refuses("orientation", Eigen::Vector4d(0, 0, nan, 1), "finite");
  refuses("frames", Scalars::Ones(4), "4 numbers for 66 vertices");
  Scalars frames = Scalars::Zero(4 * 66);
  frames[21] = nan;
  CHECK(refuses("frames", frames, "vertex 5") == 5);
  refuses("polyhedron", Scalars::Ones(39), "12 rows");
  refuses("polyhedron", Scalars::Ones(4), "three numbers");
  for (const double bad : {0.0, 1e-4, 60.0, nan, std::numeric_limits<double>::infinity()}) {
    Scalars rows = Scalars::Ones(9);
    rows.segment<3>(3).setConstant(bad);
    refuses("polyhedron", rows, "row 1");
  }
  CHECK(session.set("lambda", encoded(Scalars::Ones(2))).code == Code::badParameter);
  CHECK(session.set("localStep", encoded(Scalars::Ones(3))).code == Code::badParameter);
  CHECK(session.prepare().ok());

  REQUIRE(session.set("lambdaAxes", encoded(Vec3(1, 1, 0.5))).ok());
  REQUIRE(session.set("polyhedron", encoded("hexagonal-prism")).ok());
  const Status status = session.prepare();
  CHECK(status.code == Code::badParameter);
  CHECK(status.message.find("lambdaAxes") != std::string::npos);
  REQUIRE(session.set("polyhedron", encoded(someRows())).ok());
  CHECK(session.prepare().code == Code::badParameter);
  REQUIRE(session.set("polyhedron", encoded("cube")).ok());
  CHECK(session.prepare().ok());
}
