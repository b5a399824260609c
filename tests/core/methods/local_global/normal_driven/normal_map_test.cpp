#include <doctest/doctest.h>

#include <cmath>
#include <limits>

#include "geometry/surface.h"
#include "session/session.h"
#include "support/allocations.h"
#include "support/shapes.h"
#include "targets/texture_normals.h"

using namespace whittle;
using namespace whittle::testing;

namespace {

/// A texture of the same slope all over, whose texture coordinates are a linear map of x and y.
TextureSlopes slopeOn(const TriangleMesh& mesh, const Eigen::Matrix2d& toUv, const Eigen::Vector2d& slope) {
  TextureSlopes texture{CornerPairs(3 * mesh.faceCount(), 2), CornerPairs(3 * mesh.faceCount(), 2)};
  for (Index c = 0; c < 3 * mesh.faceCount(); ++c) {
    const auto place = mesh.positions.row(mesh.triangles(c / 3, c % 3)).head<2>();
    texture.uvs.row(c) = (toUv * place.transpose()).transpose().cast<float>();
    texture.slopes.row(c) = slope.transpose().cast<float>();
  }
  return texture;
}

Eigen::Matrix2d mirroredX() { return Eigen::Vector2d(-1, 1).asDiagonal(); }

/// Waves over the plane, their slopes in its own coordinates.
TextureSlopes waves(const TriangleMesh& mesh, double height, double periods) {
  TextureSlopes texture = slopeOn(mesh, Eigen::Matrix2d::Identity(), {0, 0});
  const double k = 2 * EIGEN_PI * periods;
  for (Index c = 0; c < texture.slopes.rows(); ++c) {
    const double u = texture.uvs(c, 0), v = texture.uvs(c, 1);
    texture.slopes.row(c) << static_cast<float>(height * k * std::cos(k * u) * std::sin(k * v)),
        static_cast<float>(height * k * std::sin(k * u) * std::cos(k * v));
  }
  return texture;
}

void prepareNormalmap(Session& session, const TriangleMesh& mesh, const TextureSlopes& texture,
                      const std::string& regularizer) {
  REQUIRE(session.load(mesh).ok());
  REQUIRE(session.select("normalmap").ok());
  REQUIRE(session.set("image", encoded(texture)).ok());
  REQUIRE(session.set("regularizer", encoded(regularizer)).ok());
  REQUIRE(session.prepare().ok());
}

/// Largest distance of rows from a vector.
double farthest(const Points& rows, const Vec3& from) {
  return (rows.rowwise() - from.transpose()).rowwise().norm().maxCoeff();
}

}  // namespace

TEST_CASE("a slope tilts normals against it, in the frame of the texture") {
  const TriangleMesh mesh = grid(5);
  const Points upright = vertexNormals(mesh.positions, mesh.triangles),
               faces = faceNormals(mesh.positions, mesh.triangles);
  const Eigen::Matrix2d plain = Eigen::Matrix2d::Identity(), stretched = Eigen::Vector2d(7, 0.3).asDiagonal();
  for (const Eigen::Matrix2d& toUv : {plain, stretched}) {
    const TextureSlopes texture = slopeOn(mesh, toUv, {0.75, 0});
    CHECK(farthest(raisedVertexNormals(mesh, upright, texture, 1), {-0.6, 0, 0.8}) < 1e-6);
    CHECK(farthest(raisedFaceNormals(mesh, faces, texture, 1), {-0.6, 0, 0.8}) < 1e-6);
    CHECK(farthest(raisedVertexNormals(mesh, upright, texture, -1), {0.6, 0, 0.8}) < 1e-6);
  }
  // u grows to the left: what rises with u falls with x; what rises with v still rises with y.
  CHECK(farthest(raisedVertexNormals(mesh, upright, slopeOn(mesh, mirroredX(), {0.75, 0}), 1), {0.6, 0, 0.8}) < 1e-6);
  CHECK(farthest(raisedVertexNormals(mesh, upright, slopeOn(mesh, mirroredX(), {0, 0.75}), 1), {0, -0.6, 0.8}) < 1e-6);
  CHECK(farthest(raisedFaceNormals(mesh, faces, slopeOn(mesh, mirroredX(), {0, 0.75}), 1), {0, -0.6, 0.8}) < 1e-6);
}

TEST_CASE("at a seam a vertex has the mean of both sides") {
  // The left half carries the texture mirrored: a roof along the middle.
  const TriangleMesh mesh = grid(5);
  const TextureSlopes right = slopeOn(mesh, Eigen::Matrix2d::Identity(), {0.75, 0}),
                      left = slopeOn(mesh, mirroredX(), {0.75, 0});
  TextureSlopes roof = right;
  for (Index c = 0; c < roof.uvs.rows(); ++c) {
    const bool isLeft = mesh.positions(mesh.triangles(c / 3, 0), 0) + mesh.positions(mesh.triangles(c / 3, 1), 0) +
                            mesh.positions(mesh.triangles(c / 3, 2), 0) <
                        1.5;
    if (isLeft) roof.uvs.row(c) = left.uvs.row(c);
  }
  const Points raised = raisedVertexNormals(mesh, vertexNormals(mesh.positions, mesh.triangles), roof, 1);
  for (Index v = 0; v < mesh.vertexCount(); ++v) {
    const double x = mesh.positions(v, 0);
    const double wanted = x < 0.4 ? 0.6 : x > 0.6 ? -0.6 : 0;
    const bool isCornerOfSeam = wanted == 0 && (mesh.positions(v, 1) == 0 || mesh.positions(v, 1) == 1);
    if (!isCornerOfSeam) CHECK(raised(v, 0) == doctest::Approx(wanted).epsilon(1e-6));
  }
}

TEST_CASE("what is flat, or has no frame, keeps its normal to the bit") {
  TriangleMesh mesh = bent(sphere(3));
  const Points normals = vertexNormals(mesh.positions, mesh.triangles),
               faces = faceNormals(mesh.positions, mesh.triangles);
  const TextureSlopes steep = slopeOn(mesh, Eigen::Matrix2d::Identity(), {0.5, 0.2});
  CHECK(raisedVertexNormals(mesh, normals, steep, 0) == normals);
  CHECK(raisedFaceNormals(mesh, faces, steep, 0) == faces);
  TextureSlopes missing = steep, single = steep;
  missing.uvs.setConstant(std::numeric_limits<float>::quiet_NaN());
  single.uvs.setConstant(0.5f);
  for (const TextureSlopes& texture : {missing, single}) {
    CHECK(raisedVertexNormals(mesh, normals, texture, 1) == normals);
    CHECK(raisedFaceNormals(mesh, faces, texture, 1) == faces);
    CHECK(validateTextureSlopes(texture, mesh.faceCount()).code == Code::unsuitableMesh);
  }
  for (const std::string regularizer : {"arap", "farap", "acap"}) {
    Session session;
    prepareNormalmap(session, mesh, slopeOn(mesh, Eigen::Matrix2d::Identity(), {0, 0}), regularizer);
    StepReport report;
    for (int step = 0; step < 5; ++step) REQUIRE(session.step(report).ok());
    Points positions(mesh.vertexCount(), 3);
    session.copyPositions(positions.data());
    CHECK(positions == mesh.positions);
  }
}

TEST_CASE("the energy never rises, steps claim no memory, and faces come to face where the texture says") {
  const TriangleMesh mesh = grid(60);
  const TextureSlopes texture = waves(mesh, 0.02, 2);
  const Points targets = raisedFaceNormals(mesh, faceNormals(mesh.positions, mesh.triangles), texture, 1);
  const auto meanAngle = [&](const Points& positions) {
    const Points normals = faceNormals(positions, mesh.triangles);
    double sum = 0;
    for (Index f = 0; f < mesh.faceCount(); ++f) sum += std::acos(std::min(1.0, normals.row(f).dot(targets.row(f))));
    return sum / mesh.faceCount() * 180 / EIGEN_PI;
  };
  for (const std::string regularizer : {"arap", "farap", "acap"}) {
    Session session;
    prepareNormalmap(session, mesh, texture, regularizer);
    StepReport report;
    REQUIRE(session.step(report).ok());
    double last = report.energy;
    const long claimed = allocationCount();
    while (report.outcome == Outcome::running) {
      REQUIRE(session.step(report).ok());
      CHECK(report.energy <= last * (1 + 1e-7));
      last = report.energy;
    }
    CHECK(allocationCount() == claimed);
    CHECK(report.outcome == Outcome::converged);
    Points positions(mesh.vertexCount(), 3);
    session.copyPositions(positions.data());
    MESSAGE("regularizer " << regularizer << ": " << meanAngle(mesh.positions) << "° before, " << meanAngle(positions)
                           << "° after");
    CHECK(meanAngle(positions) < 0.15 * meanAngle(mesh.positions));
  }
}

TEST_CASE("what cannot be done with a texture is refused by name") {
  const TriangleMesh mesh = grid(4);
  const TextureSlopes good = waves(mesh, 0.1, 1);
  Session session;
  REQUIRE(session.load(mesh).ok());
  REQUIRE(session.select("normalmap").ok());
  const Status none = session.prepare();
  CHECK(none.code == Code::badParameter);
  CHECK(none.message.find("needs an image") != std::string::npos);
  CHECK(session.set("strength", encoded(good)).code == Code::badParameter);
  CHECK(session.set("image", encoded(waves(grid(5), 0.1, 1))).code == Code::badParameter);
  TextureSlopes infinite = good;
  infinite.slopes(3, 1) = std::numeric_limits<float>::infinity();
  CHECK(session.set("image", encoded(infinite)).code == Code::badParameter);
  REQUIRE(session.set("image", encoded(good)).ok());
  REQUIRE(session.prepare().ok());
  REQUIRE(session.set("image", EncodedValue()).ok());
  CHECK(session.prepare().code == Code::badParameter);
}
