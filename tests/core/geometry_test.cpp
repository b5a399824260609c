#include <doctest/doctest.h>

#include <Eigen/Eigenvalues>

#include "geometry/edge_set.h"
#include "geometry/surface.h"
#include "support/shapes.h"

using namespace whittle;
using namespace whittle::testing;

namespace {

Eigen::MatrixXd denseLaplacian(const TriangleMesh& mesh) {
  return cotangentLaplacian(mesh.triangles, halfCotangents(mesh.positions, mesh.triangles), mesh.vertexCount());
}

double smallestEigenvalue(const Eigen::MatrixXd& A) {
  return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(A).eigenvalues().minCoeff();
}

TriangleMesh oneTriangle(const Vec3& a, const Vec3& b, const Vec3& c) {
  TriangleMesh mesh{Points(3, 3), Triangles(1, 3)};
  mesh.positions << a.transpose(), b.transpose(), c.transpose();
  mesh.triangles << 0, 1, 2;
  return mesh;
}

/// The energy by its definition: every element, every face around it, every edge of that.
double energyByDefinition(EdgeSetKind kind, const TriangleMesh& rest, const Points& output, const std::vector<Mat3>& R) {
  const CornerScalars c = halfCotangents(rest.positions, rest.triangles);
  double energy = 0;
  for (Index f = 0; f < rest.faceCount(); ++f) {
    for (int k = 0; k < (kind == EdgeSetKind::faces ? 1 : 3); ++k) {
      const Mat3& Rk = R[kind == EdgeSetKind::faces ? f : rest.triangles(f, k)];
      for (int e = 0; e < 3; ++e) {
        const Index i = rest.triangles(f, (e + 1) % 3), j = rest.triangles(f, (e + 2) % 3);
        const Vec3 d = (rest.positions.row(j) - rest.positions.row(i)).transpose();
        const Vec3 u = (output.row(j) - output.row(i)).transpose();
        energy += c(f, e) * (Rk * d - u).squaredNorm();
      }
    }
  }
  return energy;
}

std::vector<Mat3> noisyRotations(Index count) {
  Noise noise;
  std::vector<Mat3> rotations(count);
  for (Mat3& R : rotations) R = noise.rotation();
  return rotations;
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
  for (const TriangleMesh& mesh : {oneTriangle({0, 0, 0}, {1, 0, 0}, {0.3, 0, 0}), oneTriangle({0, 0, 0}, {1, 0, 0}, {1, 0, 0}),
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

TEST_CASE("both edge sets: covariances carry the energy, the global step is its gradient") {
  for (const EdgeSetKind kind : {EdgeSetKind::spokesAndRims, EdgeSetKind::faces}) {
    for (const TriangleMesh& rest : {bent(sphere(1)), bent(grid(4)), moebiusStrip(9)}) {
      const EdgeSet edges(kind, rest);
      const std::vector<Mat3> R = noisyRotations(edges.elementCount());
      const Points output = bent(rest).positions;

      std::vector<Mat3> M(edges.elementCount());
      double energy = edges.gatherCovariances(output, M);
      for (std::size_t k = 0; k < M.size(); ++k) energy -= (R[k] * M[k]).trace();
      CHECK(energy == doctest::Approx(energyByDefinition(kind, rest, output, R)).epsilon(1e-12));

      Points residual(rest.vertexCount(), 3);
      edges.scatterResidual(R, output, residual);
      const double visits = kind == EdgeSetKind::faces ? 1 : 3;
      const Points gradient = -2 * visits * residual;
      // The Hessian is the Laplacian: the residual changes by −L ΔV.
      Points elsewhere(rest.vertexCount(), 3);
      edges.scatterResidual(R, rest.positions, elsewhere);
      CHECK((residual - elsewhere + denseLaplacian(rest) * (output - rest.positions)).norm() < 1e-11);
      const double h = 1e-6;
      for (Index v = 0; v < rest.vertexCount(); v += 5) {
        for (int axis = 0; axis < 3; ++axis) {
          Points plus = output, minus = output;
          plus(v, axis) += h;
          minus(v, axis) -= h;
          const double slope = (energyByDefinition(kind, rest, plus, R) - energyByDefinition(kind, rest, minus, R)) / (2 * h);
          CHECK(gradient(v, axis) == doctest::Approx(slope).epsilon(1e-6));
        }
      }
    }
  }
}
