#include "constraints/attachments.h"

#include <doctest/doctest.h>

#include <set>

#include "constraints/contact_search.h"
#include "geometry/triangle_contact.h"
#include "session/session.h"
#include "simd/lane_algebra.h"
#include "support/allocations.h"
#include "support/shapes.h"
#include "support/style_runs.h"

using namespace whittle;
using namespace whittle::testing;

namespace {

std::vector<Attachment> contactsOf(const TriangleMesh& mesh) {
  ContactSearch search(mesh, partsByEdges(mesh.triangles, mesh.vertexCount()));
  while (search.next() < 1) {
  }
  return search.take();
}

TriangleMesh turned(TriangleMesh mesh, double degrees) {
  const Mat3 R = Eigen::AngleAxisd(degrees * EIGEN_PI / 180, Vec3::UnitZ()).toRotationMatrix();
  mesh.positions = (mesh.positions * R.transpose()).eval();
  return mesh;
}

/// Two slender arms that cross at their ends, none along an axis; together about 1 long.
TriangleMesh elbow() {
  TriangleMesh mesh = together(turned(longBox(18, 3), 12), turned(longBox(18, 3), 84), Vec3(0.55, 0.62, 0.04));
  mesh.positions *= 0.15;
  return mesh;
}

Points runCubic(const TriangleMesh& mesh, double lambda, const std::string& parts, std::vector<double>* energies,
                const Handles& handles = {}) {
  Session session;
  REQUIRE(session.load(mesh).ok());
  REQUIRE(session.select("cubic").ok());
  REQUIRE(session.set("lambda", encoded(lambda)).ok());
  REQUIRE(session.set("parts", encoded(parts)).ok());
  REQUIRE(session.set("handles", encoded(handles)).ok());
  REQUIRE(session.prepare().ok());
  const Run run = finish(session);
  if (energies) *energies = run.energies;
  return run.positions;
}

double widestGap(const std::vector<Attachment>& rows, const Points& before, const Points& after) {
  double widest = 0;
  for (const Attachment& row : rows) {
    Vec3 gap = Vec3::Zero();
    for (int i = 0; i < Attachment::kMost; ++i)
      gap += row.weights[i] * (after.row(row.vertices[i]) - before.row(row.vertices[i])).transpose();
    widest = std::max(widest, gap.norm());
  }
  return widest;
}

double angleToCube(const TriangleMesh& mesh, const Points& positions) {
  const GaussMap cube(cubeStyle());
  return angleToStyle(positions, mesh.triangles, cube);
}

}  // namespace

TEST_CASE("the nearest point of a triangle is nearer than all others") {
  Noise noise;
  for (int n = 0; n < 200; ++n) {
    const Vec3 a = noise.direction(), b = noise.direction(), c = n % 9 ? noise.direction() : a, p = noise.direction();
    const Vec3 best = nearestPoint(p, a, b, c);
    CHECK(best.minCoeff() >= 0);
    CHECK(best.sum() == doctest::Approx(1));
    const double distance = (best[0] * a + best[1] * b + best[2] * c - p).norm();
    for (int i = 0; i <= 10; ++i) {
      for (int j = 0; i + j <= 10; ++j) CHECK(distance <= ((i * a + j * b + (10 - i - j) * c) / 10 - p).norm() + 1e-12);
    }
  }
}

TEST_CASE("contacts are found as by holding everything against everything") {
  TriangleMesh second = sphere(3);
  second.positions = (second.positions * someRotation().transpose()).eval();
  TriangleMesh mesh = together(sphere(3), second, Vec3(1.2, 0.3, 0.1));
  mesh.positions *= 0.3;
  const Components parts = connectedComponents(mesh.triangles, mesh.vertexCount());
  const auto at = [&](Index v) -> Vec3 { return mesh.positions.row(v).transpose(); };
  std::set<std::pair<Index, Index>> edges;
  for (Index f = 0; f < mesh.faceCount(); ++f) {
    for (int k = 0; k < 3; ++k) edges.insert(std::minmax({mesh.triangles(f, k), mesh.triangles(f, (k + 1) % 3)}));
  }
  std::size_t expected = 0;
  std::set<Index> near;
  for (Index f = 0; f < mesh.faceCount(); ++f) {
    const auto corners = mesh.triangles.row(f);
    const Vec3 a = at(corners[0]), b = at(corners[1]), c = at(corners[2]);
    const Index part = parts.ofVertex[corners[0]];
    for (const auto& [v, w] : edges) expected += parts.ofVertex[v] != part && crossing(at(v), at(w), a, b, c);
    for (Index v = 0; v < mesh.vertexCount(); ++v) {
      const Vec3 weights = nearestPoint(at(v), a, b, c);
      const double distance = (weights[0] * a + weights[1] * b + weights[2] * c - at(v)).norm();
      if (parts.ofVertex[v] != part && distance < kContactReach) near.insert(v);
    }
  }
  for (const auto& [v, w] : edges) {
    for (const auto& [a, b] : edges) {
      if (parts.ofVertex[v] == parts.ofVertex[a] || v > a) continue;
      const auto found = nearestBetween(at(v), at(w), at(a), at(b));
      expected += found && found->distance < kContactReach;
    }
  }
  REQUIRE(expected > 20);
  const std::vector<Attachment> rows = contactsOf(mesh);
  CHECK(rows.size() == expected + near.size());
  for (const Attachment& row : rows) {
    Vec3 offset = Vec3::Zero();
    double sum = 0;
    for (int i = 0; i < Attachment::kMost; ++i) offset += row.weights[i] * at(row.vertices[i]), sum += row.weights[i];
    CHECK(offset.norm() <= kContactReach * (1 + 1e-9));
    CHECK(sum == doctest::Approx(0).epsilon(1e-12));
    CHECK(parts.ofVertex[row.vertices[0]] != parts.ofVertex[row.vertices[4]]);
  }
}

TEST_CASE("a part within another, parts that do not touch and single parts have no contacts") {
  TriangleMesh inner = sphere(2);
  inner.positions *= 0.5;
  CHECK(contactsOf(sphere(3)).empty());
  CHECK(contactsOf(together(sphere(3), inner, Vec3::Zero())).empty());
  CHECK(contactsOf(together(sphere(3), sphere(3), Vec3(2.01, 0, 0))).empty());
  CHECK(!contactsOf(together(sphere(3), sphere(3), Vec3(2.001, 0, 0))).empty());
}

TEST_CASE("the nearest points of two segments are nearer than all others") {
  Noise noise;
  int count = 0;
  for (int n = 0; n < 200; ++n) {
    const Vec3 p = noise.direction(), q = noise.direction(), a = noise.direction(), b = noise.direction();
    const auto found = nearestBetween(p, q, a, b);
    if (!found) continue;
    ++count;
    const auto distance = [&](double s, double t) { return (p + s * (q - p) - a - t * (b - a)).norm(); };
    CHECK(found->distance == doctest::Approx(distance(found->alongFirst, found->alongSecond)));
    for (int i = 0; i <= 10; ++i) {
      for (int j = 0; j <= 10; ++j) CHECK(found->distance <= distance(i / 10.0, j / 10.0) + 1e-12);
    }
  }
  CHECK(count > 20);
  CHECK(!nearestBetween(Vec3::Zero(), Vec3::UnitX(), Vec3::UnitY(), Vec3(1, 1, 0)));
}

TEST_CASE("planks that lie across each other touch where their edges cross") {
  const TriangleMesh plank = longBox(8, 1);
  TriangleMesh across = plank;
  for (Index v = 0; v < plank.vertexCount(); ++v)
    across.positions.row(v) << -plank.positions(v, 1), plank.positions(v, 0), plank.positions(v, 2);
  TriangleMesh mesh = together(plank, across, Vec3(7.35, -3.6, 1));  // at the end of the lower one
  mesh.positions /= 8;
  const std::vector<Attachment> rows = contactsOf(mesh);
  CHECK(rows.size() >= 4);
  const TriangleMesh slanted = turned(mesh, 20);
  CHECK(widestGap(rows, slanted.positions, runCubic(slanted, 0.4, "free", nullptr)) > 0.02);
  CHECK(widestGap(rows, slanted.positions, runCubic(slanted, 0.4, "together", nullptr)) < 0.004);
}

TEST_CASE("parts that share no more than a vertex are parts, and touch") {
  const TriangleMesh box = longBox(4, 2);
  TriangleMesh mesh = together(box, turned(box, 30), Vec3(0.5, 0.5, 1));
  mesh.positions /= 3;
  // The lower one's vertex under the corner at which the upper one was turned takes that corner's place.
  const Eigen::RowVector3d place = Eigen::RowVector3d(0.5, 0.5, 1) / 3;
  std::vector<Index> there;
  for (Index v = 0; v < mesh.vertexCount(); ++v) {
    if ((mesh.positions.row(v) - place).norm() < 1e-9) there.push_back(v);
  }
  REQUIRE(there.size() == 2);
  for (Index c = 0; c < mesh.triangles.size(); ++c) {
    Index& v = mesh.triangles.data()[c];
    if (v == there[1]) v = there[0];
  }
  CHECK(connectedComponents(mesh.triangles, mesh.vertexCount()).count == 2);  // and the vertex that is left over
  const std::vector<Attachment> rows = contactsOf(mesh);
  CHECK(rows.size() > 8);
  CHECK(widestGap(rows, mesh.positions, runCubic(mesh, 0.4, "free", nullptr)) > 0.02);
  CHECK(widestGap(rows, mesh.positions, runCubic(mesh, 0.4, "together", nullptr)) < 0.01);
}

TEST_CASE("forces of attachments are the gradient of their energy, and the matrix is theirs") {
  const TriangleMesh mesh = elbow();
  const Attachments attachments(contactsOf(mesh));
  REQUIRE(!attachments.empty());
  Noise noise;
  Points u(mesh.vertexCount(), 3), forces = Points::Zero(mesh.vertexCount(), 3);
  for (Index i = 0; i < u.size(); ++i) u.data()[i] = noise();
  const double energy = attachments.addForces(u, forces);
  Points product = attachments.lower(mesh.vertexCount()).selfadjointView<Eigen::Lower>() * u;
  CHECK((product + forces).norm() <= 1e-12 * forces.norm());
  CHECK(energy == doctest::Approx(product.cwiseProduct(u).sum()));

  LaneRows lanes(u.rows()), residual(u.rows());
  for (Index v = 0; v < u.rows(); ++v) setRow(lanes[v], u.row(v).transpose());
  CHECK(attachments.addForces(lanes, residual) == doctest::Approx(energy).epsilon(1e-5));
  for (Index v = 0; v < u.rows(); ++v) {
    const LaneRow& r = residual[v];
    CHECK((Vec3(r.x, r.y, r.z) - forces.row(v).transpose()).norm() <= 1e-4);
  }
}

TEST_CASE("parts that are tied are one group, numbered by their first vertex") {
  const TriangleMesh mesh = together(elbow(), sphere(1), Vec3(9, 0, 0));
  const Components parts = connectedComponents(mesh.triangles, mesh.vertexCount());
  REQUIRE(parts.count == 3);
  const Components groups = Attachments(contactsOf(mesh)).tied(parts);
  CHECK(groups.count == 2);
  CHECK(groups.ofVertex.front() == 0);
  CHECK(groups.ofVertex.back() == 1);
  CHECK(Attachments().tied(parts).count == 3);
}

TEST_CASE("what touches stays in touch, and the style arrives all the same") {
  const TriangleMesh mesh = elbow();
  const std::vector<Attachment> rows = contactsOf(mesh);
  std::vector<double> energies;
  const Points tied = runCubic(mesh, 0.4, "together", &energies), loose = runCubic(mesh, 0.4, "free", nullptr);
  CHECK(widestGap(rows, mesh.positions, loose) > 0.03);
  CHECK(widestGap(rows, mesh.positions, tied) < 0.1 * widestGap(rows, mesh.positions, loose));
  CHECK(angleToCube(mesh, mesh.positions) > 4);
  CHECK(angleToCube(mesh, tied) < 2);
  for (std::size_t k = 1; k < energies.size(); ++k) CHECK(energies[k] <= energies[k - 1] + 3e-8 * (energies[0] + 1));
}

TEST_CASE("ties change nothing where nothing is to be done, and turn with the mesh") {
  const TriangleMesh mesh = elbow();
  CHECK(runCubic(mesh, 0, "together", nullptr) == mesh.positions);
  TriangleMesh quarter = mesh;
  for (Index v = 0; v < mesh.vertexCount(); ++v)
    quarter.positions.row(v) << -mesh.positions(v, 1), mesh.positions(v, 0), mesh.positions(v, 2);
  const Points upright = runCubic(mesh, 0.3, "together", nullptr);
  const Points turned = runCubic(quarter, 0.3, "together", nullptr);
  for (Index v = 0; v < mesh.vertexCount(); ++v) {
    CHECK(turned(v, 0) == doctest::Approx(-upright(v, 1)).epsilon(0.01));
    CHECK(turned(v, 1) == doctest::Approx(upright(v, 0)).epsilon(0.01));
  }
}

TEST_CASE("a handle on one part carries those that touch it, and no others") {
  const TriangleMesh mesh = together(elbow(), elbow(), Vec3(4, 0, 0));
  Handles handles{{0}, mesh.positions.row(0)};
  handles.targets.row(0) += Eigen::RowVector3d(0.5, 0.25, 0);
  const Points moved = runCubic(mesh, 0, "together", nullptr, handles);
  const Index half = mesh.vertexCount() / 2;
  for (Index v = 0; v < mesh.vertexCount(); ++v) {
    const Vec3 move = (moved.row(v) - mesh.positions.row(v)).transpose();
    CHECK((move - (v < half ? Vec3(0.5, 0.25, 0) : Vec3(0, 0, 0))).norm() < (v < half ? 0.03 : 1e-9));
  }
}

TEST_CASE("a step with attachments allocates nothing") {
  const TriangleMesh mesh = elbow();
  Session session;
  REQUIRE(session.load(mesh).ok());
  REQUIRE(session.select("cubic").ok());
  REQUIRE(session.prepare().ok());
  StepReport report;
  REQUIRE(session.step(report).ok());
  const long before = allocationCount();
  REQUIRE(session.step(report).ok());
  CHECK(allocationCount() == before);
}

TEST_CASE("polycubes keep their parts in touch") {
  const TriangleMesh mesh = elbow();
  const std::vector<Attachment> rows = contactsOf(mesh);
  const auto gapOf = [&](const std::string& parts) {
    Session session;
    REQUIRE(session.load(mesh).ok());
    REQUIRE(session.select("polycube").ok());
    REQUIRE(session.set("directions", encoded(cubeStyle())).ok());
    REQUIRE(session.set("parts", encoded(parts)).ok());
    REQUIRE(session.prepare().ok());
    return widestGap(rows, mesh.positions, finish(session).positions);
  };
  CHECK(gapOf("together") < 0.2 * gapOf("free"));
}
