#include <doctest/doctest.h>

#include <Eigen/Eigenvalues>

#include "geometry/cotangent.h"
#include "geometry/surface.h"
#include "support/shapes.h"
#include "support/surface_measures.h"

using namespace whittle;
using namespace whittle::testing;

namespace {

double smallestEigenvalue(const Eigen::MatrixXd& A) {
  return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(A).eigenvalues().minCoeff();
}

TriangleMesh oneTriangle(const Vec3& a, const Vec3& b, const Vec3& c) {
  TriangleMesh mesh{Points(3, 3), Triangles(1, 3)};
  mesh.positions << a.transpose(), b.transpose(), c.transpose();
  mesh.triangles << 0, 1, 2;
  return mesh;
}

}  // namespace

TEST_CASE("half cotangents of known triangles") {
  const TriangleMesh right = oneTriangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  const CornerScalars c = halfCotangents(right.positions, right.triangles);
  CHECK(c(0, 0) == doctest::Approx(0));
  CHECK(c(0, 1) == doctest::Approx(0.5));
  CHECK(c(0, 2) == doctest::Approx(0.5));
  const TriangleMesh obtuse = oneTriangle({0, 0, 0}, {2, 0, 0}, {1, 0.5, 0});
  CHECK(halfCotangents(obtuse.positions, obtuse.triangles)(0, 2) < 0);
}

TEST_CASE("the cotangent Laplacian is semidefinite, flat on constants and exact on linear functions") {
  const TriangleMesh mesh = bent(sphere(2));
  const Eigen::MatrixXd L = denseLaplacian(mesh);
  CHECK((L - L.transpose()).norm() < 1e-14);
  CHECK(L.rowwise().sum().norm() < 1e-12);
  CHECK(smallestEigenvalue(L) > -1e-12);
  // Interior vertices of a flat mesh: the Laplacian of a coordinate vanishes.
  const TriangleMesh flat = grid(5);
  const Eigen::MatrixXd curvature = denseLaplacian(flat) * flat.positions;
  CHECK(curvature.row(12).norm() < 1e-13);
}

TEST_CASE("degenerate faces leave the Laplacian finite and semidefinite") {
  for (const TriangleMesh& mesh :
       {oneTriangle({0, 0, 0}, {1, 0, 0}, {0.3, 0, 0}), oneTriangle({0, 0, 0}, {1, 0, 0}, {1, 0, 0}),
        oneTriangle({0, 0, 0}, {1, 0, 0}, {0.5, 1e-14, 0}), oneTriangle({1, 1, 1}, {1, 1, 1}, {1, 1, 1})}) {
    const Eigen::MatrixXd L = denseLaplacian(mesh);
    CHECK(L.allFinite());
    CHECK(smallestEigenvalue(L) >= -1e-8 * (1 + L.norm()));
  }
}

TEST_CASE("areas and normals of a sphere") {
  const TriangleMesh mesh = sphere(4);
  const Scalars vertexAreas = barycentricAreas(mesh.positions, mesh.triangles);
  CHECK(vertexAreas.sum() == doctest::Approx(faceAreas(mesh.positions, mesh.triangles).sum()));
  CHECK(vertexAreas.sum() == doctest::Approx(4 * EIGEN_PI).epsilon(0.01));
  const Points normals = vertexNormals(mesh.positions, mesh.triangles);
  CHECK((normals - mesh.positions).rowwise().norm().maxCoeff() < 0.03);
}

TEST_CASE("a vertex whose faces cancel has no normal") {
  TriangleMesh mesh = oneTriangle({0, 0, 0}, {1, 0, 0}, {0.3, 0.7, 0.1});
  mesh.triangles.resize(2, 3);
  mesh.triangles << 0, 1, 2, 0, 2, 1;
  CHECK(vertexNormals(mesh.positions, mesh.triangles).isZero(0));
}
