#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "geometry/surface.h"
#include "support/allocations.h"
#include "support/shapes.h"
#include "support/style_runs.h"
#include "support/surface_measures.h"

using namespace whittle;
using namespace whittle::testing;

namespace {

const std::string kArap = "arap", kFarap = "farap", kAcap = "acap";
const std::string kAll[] = {kArap, kFarap, kAcap};

double largestMove(const Points& a, const Points& b) { return (a - b).rowwise().norm().maxCoeff(); }

/// But for single precision, of the energy and of the terms that cancel in it (about 1 in the unit frame).
void requireMonotone(const std::vector<double>& energies) {
  for (std::size_t k = 1; k < energies.size(); ++k)
    REQUIRE(energies[k] <= energies[k - 1] + 1e-7 * (std::abs(energies[0]) + 1));
}

GaussMapData sphereStyle(int levels) {
  const TriangleMesh mesh = sphere(levels);
  return {GaussMapData::Kind::perVertex, mesh.positions, mesh.positions, mesh.triangles};
}

}  // namespace

TEST_CASE("with targets that stay, the energy never rises") {
  for (const TriangleMesh& mesh :
       {bent(sphere(3)), bent(grid(12)), torus(20), together(bent(sphere(2)), torus(12), {4, 0, 0})}) {
    for (const std::string& regularizer : kAll) {
      for (const double lambda : {0.1, 1.0, 8.0}) {
        for (const char* acceleration : {"nesterov", "none"}) {
          const Run result = run(mesh, {octahedronStyle(), lambda, regularizer, false, 1e-4, 120, acceleration});
          CHECK(result.positions.allFinite());
          requireMonotone(result.energies);
        }
      }
    }
  }
}

TEST_CASE("a sphere in the style of a cube is a cube") {
  const TriangleMesh mesh = sphere(4);
  const GaussMap cube(cubeStyle());
  for (const std::string& regularizer : kAll) {
    const Run result = run(mesh, {cubeStyle(), 4, regularizer, false, 1e-4, 1000});
    CHECK(angleToStyle(result.positions, mesh.triangles, cube) < 8.5);
    // How much of its box it fills: a sphere 0.52.
    double sixfold = 0;
    for (Index f = 0; f < mesh.faceCount(); ++f) {
      const auto at = [&](int k) -> Vec3 { return result.positions.row(mesh.triangles(f, k)).transpose(); };
      sixfold += at(0).dot(at(1).cross(at(2)));
    }
    const Eigen::RowVector3d box = result.positions.colwise().maxCoeff() - result.positions.colwise().minCoeff();
    MESSAGE("regularizer " << regularizer << ": box fill " << sixfold / 6 / box.prod() << ", angle "
                           << angleToStyle(result.positions, mesh.triangles, cube));
    CHECK(sixfold / 6 / box.prod() > 0.85);
  }
}

TEST_CASE("normals come closer to the style, the more the higher lambda is") {
  for (const TriangleMesh& mesh : {bent(sphere(3)), torus(24), bent(grid(16)), bent(longBox(12, 5))}) {
    for (const GaussMapData& data : {cubeStyle(), octahedronStyle()}) {
      const GaussMap style(data);
      for (const std::string& regularizer : kAll) {
        double last = angleToStyle(mesh.positions, mesh.triangles, style);
        for (const double lambda : {0.2, 2.0}) {
          const Run result = run(mesh, {data, lambda, regularizer});
          const double angle = angleToStyle(result.positions, mesh.triangles, style);
          CHECK(angle < last + 0.5);  // vertex rotations have had enough sooner than face rotations
          last = angle;
        }
      }
    }
  }
}

TEST_CASE("turning style and mesh together turns the result") {
  const TriangleMesh mesh = bent(sphere(3));
  // About the axis of the turn that decides ties, which does not turn with the style: about any other, a normal within 1e-3
  // radians of the border between two of the style's may fall to the other one.
  const Mat3 R = Eigen::AngleAxisd(1.1, GaussMap::kTieAxis).toRotationMatrix();
  TriangleMesh turned = mesh;
  turned.positions = mesh.positions * R.transpose();
  for (const std::string& regularizer : kAll) {
    for (const bool isDynamic : {false, true}) {
      for (const bool isSphere : {false, true}) {
        Analogy analogy{isSphere ? sphereStyle(2) : octahedronStyle(), 1, regularizer, isDynamic, 3e-3, 25};
        // Where the mesh is symmetric its normals must not lie between two of the style's.
        if (!isSphere) analogy.style.normals = (analogy.style.normals * someRotation()).eval();
        // Some smooth style that is not the sphere itself.
        if (isSphere) analogy.style.normals.array() *= analogy.style.normals.array().square();
        const Points plain = run(mesh, analogy).positions;
        analogy.style.normals = (analogy.style.normals * R.transpose()).eval();
        analogy.style.points = (analogy.style.points * R.transpose()).eval();
        INFO("regularizer " << regularizer << ", dynamic " << isDynamic << ", sphere " << isSphere);
        CHECK(largestMove(run(turned, analogy).positions, plain * R.transpose()) < 3e-4);
      }
    }
  }
}

TEST_CASE("sides that lie between several normals of the style stay flat, whatever rounding says") {
  TriangleMesh mesh = blocks({{0, 0, 0}}, 10);
  Noise noise;
  for (Index i = 0; i < mesh.positions.size(); ++i) mesh.positions.data()[i] += 1e-7 * noise();
  for (const std::string& regularizer : {kArap, kFarap}) {
    const Points positions = run(mesh, {octahedronStyle(), 1, regularizer}).positions;
    CHECK(bentPairCount(mesh, positions) == 0);
    CHECK(volumeInside(positions, mesh.triangles) > 0.85);
  }
}

TEST_CASE("a block in the style of a cube is at rest, and its corners look three ways in that of another") {
  const TriangleMesh mesh = blocks({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, 2);
  for (const std::string& regularizer : kAll) {
    for (const bool isDynamic : {false, true}) {
      CHECK(run(mesh, {cubeStyle(), 1, regularizer, isDynamic}).positions == mesh.positions);
    }
    GaussMapData turnedCube = cubeStyle();
    const Mat3 R = Eigen::AngleAxisd(0.3, Vec3(1, 2, 3).normalized()).toRotationMatrix();
    turnedCube.normals = (turnedCube.normals * R.transpose()).eval();
    const Points positions = run(mesh, {turnedCube, 1, regularizer, false, 1e-6, 2000}).positions;
    CHECK(angleToStyle(positions, mesh.triangles, GaussMap(turnedCube)) < 0.2);
  }
}

TEST_CASE("a style that asks for what is there leaves the mesh alone, to the bit without lambda") {
  for (const TriangleMesh& mesh : {bent(sphere(3)), bent(grid(9)), torus(14)}) {
    for (const std::string& regularizer : kAll) {
      for (const bool isDynamic : {false, true}) {
        CHECK(largestMove(run(mesh, {sphereStyle(3), 1, regularizer, isDynamic}).positions, mesh.positions) < 2e-6);
        CHECK(largestMove(run(mesh, {cubeStyle(), 0, regularizer, isDynamic}).positions, mesh.positions) == 0);
      }
    }
  }
}

TEST_CASE("scales make growing free, rotations alone do not") {
  const TriangleMesh mesh = bent(sphere(3));
  Handles handles{{}, mesh.positions};
  for (Index v = 0; v < mesh.vertexCount(); v += 9) handles.vertices.push_back(v);
  handles.targets.resize(handles.vertices.size(), 3);
  const Mat3 similarity = 1.7 * someRotation();
  for (std::size_t h = 0; h < handles.vertices.size(); ++h) {
    handles.targets.row(h) = mesh.positions.row(handles.vertices[h]) * similarity.transpose();
  }
  Session session;
  for (const std::string& regularizer : kAll) {
    REQUIRE(session.load(mesh).ok());
    REQUIRE(session.select("arap").ok());
    REQUIRE(session.set("regularizer", encoded(regularizer)).ok());
    REQUIRE(session.set("tolerance", encoded(1e-9)).ok());
    REQUIRE(session.set("maxIterations", encoded(3000)).ok());
    REQUIRE(session.set("handles", encoded(handles)).ok());
    REQUIRE(session.prepare().ok());
    StepReport report;
    while (report.outcome == Outcome::running) REQUIRE(session.step(report).ok());
    Points positions(mesh.vertexCount(), 3);
    session.copyPositions(positions.data());
    const double error = largestMove(positions, mesh.positions * similarity.transpose());
    if (regularizer == kAcap) {
      CHECK(error < 1e-4);
      CHECK(report.energy < 4e-6);
      CHECK(report.energy >= 0);
    } else {
      CHECK(error > 1e-2);
      CHECK(report.energy > 1e-3);
    }
  }
}

TEST_CASE("targets that follow the output are other targets") {
  const TriangleMesh mesh = bent(sphere(3));
  const GaussMap style(octahedronStyle());
  for (const std::string& regularizer : kAll) {
    const Run fixed = run(mesh, {octahedronStyle(), 2, regularizer}),
              dynamic = run(mesh, {octahedronStyle(), 2, regularizer, true});
    CHECK(largestMove(fixed.positions, dynamic.positions) > 1e-3);
    CHECK(dynamic.positions.allFinite());
    CHECK(angleToStyle(dynamic.positions, mesh.triangles, style) < angleToStyle(mesh.positions, mesh.triangles, style));
  }
}

TEST_CASE("where targets that follow the output end worse than they began, the best shape is kept, and it is said") {
  TriangleMesh mesh = sphere(4);
  for (Index v = 0; v < mesh.vertexCount(); ++v) {
    const Eigen::RowVector3d p = mesh.positions.row(v);
    mesh.positions.row(v) *= 1 + 0.25 * std::sin(5 * p.x()) * std::cos(4 * p.y() + 3 * p.z());
  }
  Analogy analogy{sphereStyle(4), 1, kArap, true};
  for (Index v = 0; v < analogy.style.normals.rows(); ++v) {
    const Eigen::RowVector3d p = analogy.style.points.row(v);
    analogy.style.normals.row(v) +=
        0.6 * Eigen::RowVector3d(std::sin(9 * p.z()), std::cos(9 * p.x()), std::sin(9 * p.y()));
  }
  Session session;
  REQUIRE(session.load(mesh).ok());
  prepareAnalogy(session, analogy);
  const Run kept = finish(session);
  REQUIRE(kept.energies.back() > kept.energies.front());
  REQUIRE(session.warnings().size() == 1);
  // The energy before an iteration is that of the shape which the one before left.
  const auto best = std::min_element(kept.energies.begin() + 1, kept.energies.end());
  analogy.maxIterations = static_cast<int>(best - kept.energies.begin());
  CHECK(session.warnings()[0].find("iteration " + std::to_string(analogy.maxIterations)) != std::string::npos);
  CHECK(run(mesh, analogy).positions == kept.positions);

  analogy.isDynamic = false;
  prepareAnalogy(session, analogy);
  finish(session);
  CHECK(session.warnings().empty());
}

TEST_CASE("handles are met and lambda acts where it is") {
  const TriangleMesh mesh = bent(sphere(3));
  Handles handles{{0, 1, 7}, Points(3, 3)};
  for (int h = 0; h < 3; ++h) handles.targets.row(h) = mesh.positions.row(handles.vertices[h]);
  handles.targets.row(1) += Eigen::RowVector3d(-0.7, 0.2, 0.4);
  Scalars upper(mesh.vertexCount());
  for (Index v = 0; v < mesh.vertexCount(); ++v) upper[v] = mesh.positions(v, 2) > 0.2 ? 3 : 0;
  const GaussMap cube(cubeStyle());
  for (const std::string& regularizer : kAll) {
    const Run held = run(mesh, {cubeStyle(), 1, regularizer, false, 3e-3, 300, "nesterov", handles});
    for (int h = 0; h < 3; ++h) CHECK((held.positions.row(handles.vertices[h]) - handles.targets.row(h)).norm() < 1e-9);
    requireMonotone(held.energies);

    const Run half = run(mesh, {cubeStyle(), 1, regularizer, false, 3e-3, 300, "nesterov", {}, upper});
    const auto angles = [&](const Points& positions, bool isUpper) {
      Triangles some(0, 3);
      for (Index f = 0; f < mesh.faceCount(); ++f) {
        const double z = mesh.positions(mesh.triangles(f, 0), 2);
        if (isUpper ? z < 0.3 : z > -0.3) continue;
        some.conservativeResize(some.rows() + 1, 3);
        some.row(some.rows() - 1) = mesh.triangles.row(f);
      }
      return angleToStyle(positions, some, cube);
    };
    CHECK(angles(half.positions, true) < 0.75 * angles(mesh.positions, true));
    CHECK(angles(half.positions, false) > 0.85 * angles(mesh.positions, false));
  }
}

TEST_CASE("vertices without a normal have no target") {
  TriangleMesh mesh = bent(sphere(2));
  const Index count = mesh.vertexCount(), faces = mesh.faceCount();
  mesh.positions.conservativeResize(count + 4, 3);
  mesh.positions.bottomRows<4>() << 2, 0, 0, 3, 0, 0, 2, 1, 0, 0.1, 0.2, 0.3;
  mesh.triangles.conservativeResize(faces + 3, 3);
  mesh.triangles.row(faces) << count, count + 1, count + 2;  // two sheets back to back
  mesh.triangles.row(faces + 1) << count, count + 2, count + 1;
  mesh.triangles.row(faces + 2) << 0, 0, 1;
  for (const std::string& regularizer : kAll) {
    for (const bool isDynamic : {false, true}) {
      const Run result = run(mesh, {octahedronStyle(), 2, regularizer, isDynamic});
      CHECK(result.positions.allFinite());
      CHECK(result.positions.bottomRows<1>() == mesh.positions.bottomRows<1>());
    }
  }
}

TEST_CASE("the same bits twice, and a step allocates nothing") {
  const TriangleMesh mesh = bent(sphere(3));
  for (const std::string& regularizer : kAll) {
    for (const bool isDynamic : {false, true}) {
      const Analogy analogy{octahedronStyle(), 1, regularizer, isDynamic, 3e-3, 20};
      CHECK(run(mesh, analogy).positions == run(mesh, analogy).positions);
      Session session;
      REQUIRE(session.load(mesh).ok());
      prepareAnalogy(session, analogy);
      StepReport report;
      const long before = allocationCount();
      for (int step = 0; step < 5; ++step) REQUIRE(session.step(report).ok());
      CHECK(allocationCount() == before);
    }
  }
}

TEST_CASE("what an analogy cannot work with is refused with a sentence") {
  Session session;
  REQUIRE(session.load(sphere(1)).ok());
  REQUIRE(session.select("analogy").ok());
  CHECK(session.prepare().message.find("needs a style") != std::string::npos);
  CHECK(session.set("style", encoded(GaussMapData{})).code == Code::badParameter);
  CHECK(session.set("lambdaPerVertex", encoded(Scalars::Ones(5))).message.find("5 numbers for 18 vertices") !=
        std::string::npos);
  Scalars negative = Scalars::Ones(18);
  negative[3] = -1;
  const Status status = session.set("lambdaPerVertex", encoded(negative));
  CHECK(status.message.find("vertex 3") != std::string::npos);
  CHECK(status.element.index == 3);
  CHECK(session.set("lambda", encoded(Scalars::Ones(18))).code == Code::badParameter);
  CHECK(session.set("dynamicTargets", encoded(0.5)).code == Code::badParameter);
  CHECK(session.set("lambda", encoded(cubeStyle())).code == Code::badParameter);
}
