// How smooth what comes of far landmarks is, beside as-rigid-as-possible deformation by the same gesture.
#include <doctest/doctest.h>

#include <cmath>
#include <set>
#include <string>

#include "geometry/surface.h"
#include "mesh/edges.h"
#include "methods/plastic/plastic.h"
#include "session/session.h"
#include "support/runs.h"
#include "support/shapes.h"
#include "support/surface_measures.h"

using namespace whittle;
using namespace whittle::testing;

namespace {

/// A mesh, its vertices that are held or moved, and where they go.
struct Gesture {
  TriangleMesh mesh;
  Handles landmarks = {};
  std::vector<Index> moved = {};

  Vec3 at(Index vertex) const { return mesh.positions.row(vertex).transpose(); }
  void add(Index vertex, const Vec3& target) {
    landmarks.vertices.push_back(vertex);
    landmarks.targets.conservativeResize(landmarks.targets.rows() + 1, 3);
    landmarks.targets.bottomRows(1) = target.transpose();
    if (target != at(vertex)) moved.push_back(vertex);
  }
  /// Holds the vertices for which `isHeld` says so.
  template <typename Predicate>
  void hold(Predicate isHeld) {
    for (Index v = 0; v < mesh.vertexCount(); ++v) {
      if (isHeld(at(v))) add(v, at(v));
    }
  }
  Index nearest(const Vec3& place) const {
    Index best = 0;
    (mesh.positions.rowwise() - place.transpose()).rowwise().squaredNorm().minCoeff(&best);
    return best;
  }
};

/// What a gesture came to. Lengths are those of a mesh whose diagonal is 100.
struct Result {
  Points positions;
  Outcome outcome;
  std::size_t iterations;
  double error;        // mean distance of landmarks from their targets
  double spike;        // how far moved landmarks stand out of their rings, more than before, in mean edges of the ring
  double largestBend;  // change of mean curvature times the root of the area about the vertex
  double deviation;    // standard deviation of that
  int folds;           // edges folded over
};

/// Mean curvature at each vertex inside times the root of its area, signed by the normals: free of scale.
Scalars scaledCurvature(const TriangleMesh& mesh) {
  const Eigen::MatrixXd L = denseLaplacian(mesh);
  const Points laplacian = L * mesh.positions;
  const Scalars areas = barycentricAreas(mesh.positions, mesh.triangles);
  const Points normals = vertexNormals(mesh.positions, mesh.triangles);
  Scalars result(mesh.vertexCount());
  for (Index v = 0; v < mesh.vertexCount(); ++v)
    result[v] = areas[v] > 0 ? laplacian.row(v).dot(normals.row(v)) / (2 * areas[v]) * std::sqrt(areas[v]) : 0;
  return result;
}

std::vector<bool> isOnBorder(const TriangleMesh& mesh) {
  const MeshEdges edges(mesh.triangles, mesh.vertexCount());
  std::vector<bool> result(mesh.vertexCount(), false);
  for (Index e = 0; e < edges.count(); ++e) {
    if (edges.faceCountAt(e) == 1) result[edges.ends[e][0]] = result[edges.ends[e][1]] = true;
  }
  return result;
}

/// How far a vertex is from the middle of its ring, in mean edges.
double standingOut(const TriangleMesh& mesh, const Points& positions, Index vertex) {
  std::set<Index> ring;
  for (Index f = 0; f < mesh.faceCount(); ++f) {
    for (int k = 0; k < 3; ++k) {
      if (mesh.triangles(f, k) == vertex) ring.insert({mesh.triangles(f, (k + 1) % 3), mesh.triangles(f, (k + 2) % 3)});
    }
  }
  Eigen::RowVector3d middle = Eigen::RowVector3d::Zero();
  double edge = 0;
  for (const Index other : ring) {
    middle += positions.row(other) / static_cast<double>(ring.size());
    edge += (positions.row(other) - positions.row(vertex)).norm() / static_cast<double>(ring.size());
  }
  return (positions.row(vertex) - middle).norm() / edge;
}

Result solve(const Gesture& gesture, const char* method, const PlasticParameters& parameters = {}) {
  Session session;
  REQUIRE(session.load(gesture.mesh).ok());
  REQUIRE(session.select(method).ok());
  const bool isPlastic = std::string(method) == "plastic";
  REQUIRE(session.set(isPlastic ? "landmarks" : "handles", encoded(gesture.landmarks)).ok());
  if (isPlastic) REQUIRE(session.set("turn", encoded(parameters.turn)).ok());
  REQUIRE(session.prepare().ok());
  const Run run = finish(session);
  Result result{run.positions, run.outcome, run.energies.size(), 0, 0, 0, 0, 0};
  const double size =
      (gesture.mesh.positions.colwise().maxCoeff() - gesture.mesh.positions.colwise().minCoeff()).norm();
  const Handles& landmarks = gesture.landmarks;
  for (std::size_t l = 0; l < landmarks.vertices.size(); ++l) {
    const double miss =
        (run.positions.row(landmarks.vertices[l]) - landmarks.targets.row(static_cast<Index>(l))).norm();
    result.error += 100 / size * miss / static_cast<double>(landmarks.vertices.size());
  }
  for (const Index v : gesture.moved) {
    result.spike = std::max(result.spike, standingOut(gesture.mesh, run.positions, v) -
                                              standingOut(gesture.mesh, gesture.mesh.positions, v));
  }
  const Scalars before = scaledCurvature(gesture.mesh),
                after = scaledCurvature({run.positions, gesture.mesh.triangles});
  const std::vector<bool> border = isOnBorder(gesture.mesh);
  double sum = 0, squares = 0;
  for (Index v = 0; v < gesture.mesh.vertexCount(); ++v) {
    const double bend = border[v] ? 0 : std::abs(after[v] - before[v]);
    result.largestBend = std::max(result.largestBend, bend);
    sum += bend / static_cast<double>(before.size());
    squares += bend * bend / static_cast<double>(before.size());
  }
  result.deviation = std::sqrt(squares - sum * sum);
  result.folds = foldCount(run.positions, gesture.mesh.triangles);
  MESSAGE(std::string(method) << ": " << result.iterations << " iterations, error " << result.error << ", spike "
                              << result.spike << ", bend " << result.largestBend << " deviation " << result.deviation
                              << ", folds " << result.folds);
  return result;
}

/// Holds what every edit of the paper has to reach; returns the result.
Result holds(const Gesture& gesture, double spike = 0.2) {
  const Result result = solve(gesture, "plastic"), rigid = solve(gesture, "arap");
  CHECK(result.outcome == Outcome::converged);
  CHECK(result.error < 0.02);
  CHECK(result.spike < spike);
  CHECK(result.largestBend < 0.45 * rigid.largestBend);
  CHECK(result.deviation < rigid.deviation);
  CHECK(result.folds == 0);
  return result;
}

/// A plate of n×n vertices of side 1, its rim held.
Gesture plate(int n) {
  Gesture gesture{grid(n)};
  const Vec3 low = gesture.mesh.positions.colwise().minCoeff(), high = gesture.mesh.positions.colwise().maxCoeff();
  gesture.hold(
      [&](const Vec3& p) { return ((p - low).head<2>().minCoeff() < 1e-9) || (high - p).head<2>().minCoeff() < 1e-9; });
  return gesture;
}

}  // namespace

TEST_CASE("the middle of a plate is pulled up: a hill, where as rigid as possible is a spike") {
  Gesture gesture = plate(21);
  const Vec3 middle = gesture.mesh.positions.colwise().mean();
  const Index center = gesture.nearest(middle);
  gesture.add(center, gesture.at(center) + Vec3(0, 0, 0.5));
  holds(gesture);
}

TEST_CASE("a hump is pulled out of a body") {
  Gesture gesture{animal(4)};
  const double low = gesture.mesh.positions.col(1).minCoeff(), high = gesture.mesh.positions.col(1).maxCoeff();
  gesture.hold([&](const Vec3& p) { return p.y() < low + 0.2 * (high - low); });
  const Index back = gesture.nearest(Vec3(-0.4, 0.8, 0.1));
  gesture.add(back, gesture.at(back) + 0.35 * (high - low) * Vec3(0, 1, 0));
  holds(gesture);
}

TEST_CASE("a bar is twisted by a right angle, by three, and bent by a hundred and twenty degrees") {
  for (const double degrees : {90, 270, 120}) {
    const bool isTwist = degrees != 120;
    Gesture gesture{longBox(24, 4)};
    const double left = gesture.mesh.positions.col(0).minCoeff(), right = gesture.mesh.positions.col(0).maxCoeff();
    gesture.hold([&](const Vec3& p) { return p.x() < left + 1e-9; });
    const Vec3 middle = gesture.mesh.positions.colwise().mean();
    const double angle = degrees * std::acos(-1.0) / 180;
    const Mat3 turn = Eigen::AngleAxisd(angle, isTwist ? Vec3::UnitX() : Vec3(Vec3::UnitY())).toRotationMatrix();
    const Vec3 start(left, middle.y(), middle.z()), end(right, middle.y(), middle.z());
    // The end of an arc as long as the bar.
    const double length = right - left, radius = length / angle;
    const Vec3 to =
        isTwist ? end : Vec3(left + radius * std::sin(angle), middle.y(), middle.z() - radius * (1 - std::cos(angle)));
    for (Index v = 0; v < gesture.mesh.vertexCount(); ++v) {
      if (gesture.mesh.positions(v, 0) > right - 1e-9) gesture.add(v, to + turn * (gesture.at(v) - end));
    }
    const Result result = solve(gesture, "plastic", {.turn = degrees});
    CHECK(result.outcome == Outcome::converged);
    CHECK(result.error < 0.02);
    CHECK(result.folds == 0);
    // The middle has turned by half of it.
    if (!isTwist) continue;
    const Index side = gesture.nearest(middle + Vec3(0, 10, 0));
    const Vec3 arm = result.positions.row(side).transpose() - middle, rest = gesture.at(side) - middle;
    const Vec3 expected = Eigen::AngleAxisd(angle / 2, Vec3::UnitX()) * rest;
    CHECK(arm.normalized().dot(expected.normalized()) > 0.8);
  }
}

TEST_CASE("a torus that is stretched by two landmarks stays symmetric") {
  Gesture gesture{torus(24)};
  const Index left = gesture.nearest(Vec3(-10, 0, 0)), right = gesture.nearest(Vec3(10, 0, 0));
  const Index front = gesture.nearest(Vec3(0, 10, 0)), back = gesture.nearest(Vec3(0, -10, 0));
  gesture.add(front, gesture.at(front));
  gesture.add(back, gesture.at(back));
  const double reach = gesture.at(right).x();
  gesture.add(left, gesture.at(left) - Vec3(0.6 * reach, 0, 0));
  gesture.add(right, gesture.at(right) + Vec3(0.6 * reach, 0, 0));
  const Result result = solve(gesture, "plastic");
  CHECK(result.error < 0.02);
  CHECK(result.folds == 0);
  CHECK(std::abs(result.positions.col(0).maxCoeff() + result.positions.col(0).minCoeff()) < 0.03 * reach);
}

TEST_CASE("a flat shape that is pulled in its plane stays in it, and no face turns over (Fig. 15)") {
  Gesture gesture{grid(25)};
  const Vec3 low = gesture.mesh.positions.colwise().minCoeff(), high = gesture.mesh.positions.colwise().maxCoeff();
  const Index corner = gesture.nearest(high), first = gesture.nearest(low);
  const Index second = gesture.nearest(Vec3(low.x(), high.y(), 0)), third = gesture.nearest(Vec3(high.x(), low.y(), 0));
  for (const Index v : {first, second, third}) gesture.add(v, gesture.at(v));
  gesture.add(corner, gesture.at(corner) + Vec3(0.7, 0.5, 0));
  const Result result = solve(gesture, "plastic");
  CHECK(result.error < 0.02);
  CHECK(result.positions.col(2).cwiseAbs().maxCoeff() < 1e-9);
  for (Index f = 0; f < gesture.mesh.faceCount(); ++f) {
    const auto normalZ = [&](const Points& p) {
      const Vec3 a = p.row(gesture.mesh.triangles(f, 0)), b = p.row(gesture.mesh.triangles(f, 1)),
                 c = p.row(gesture.mesh.triangles(f, 2));
      return (b - a).cross(c - a).z();
    };
    CHECK(normalZ(result.positions) * normalZ(gesture.mesh.positions) > 0);
  }
}
