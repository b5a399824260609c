#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

#include "geometry/rotation_fit.h"
#include "geometry/surface.h"
#include "methods/local_global/cubic/cubic_admm.h"
#include "methods/local_global/cubic/cubic_exact.h"
#include "methods/local_global/cubic/cubic_search.h"
#include "methods/local_global/cubic/polyhedral_exact.h"
#include "session/session.h"
#include "support/shapes.h"

using namespace whittle;
using namespace whittle::testing;

namespace {

constexpr double kSingle = 3e-6;  // of an objective's scale

/// A vertex of a surface at work, as in the tests of the cubic step.
PolyhedralVertex surfaceVertex(Noise& noise, double lambda, const Polyhedron& polyhedron) {
  const Vec3 n = noise.direction(), axis = noise.direction();
  const Mat3 turn = Eigen::AngleAxisd(0.5 * noise(), axis).toRotationMatrix();
  const Mat3 M = 6 * (Mat3::Identity() - n * n.transpose()) * turn.transpose() + 0.3 * noise.matrix();
  return {M, n, lambda, polyhedron};
}

double scaleOf(const PolyhedralVertex& vertex) { return vertex.M.norm() + vertex.weight; }

/// Four vertices solved as the product does it, from the plain fits.
struct Solved {
  Mat3 R[4];
  double regularizer[4];
  bool certified[4];
  Vec3 pull[4];  // Σ l_j u_j b_j
};

Solved solve(const std::vector<PolyhedralVertex>& vertices, const Polyhedron& polyhedron) {
  MatrixLanes M;
  FanLanes fan;
  QuaternionLanes rotations;
  for (int lane = 0; lane < 4; ++lane) {
    setMatrix(M, lane, vertices[lane].M);
    setVector(fan.n, lane, vertices[lane].n);
    fan.weight[lane] = static_cast<float>(vertices[lane].weight);
    setRotation(rotations, lane, fitRotation(vertices[lane].M));
  }
  const CubicLanes lanes{M, {&fan, 1}};
  std::vector<KinkLanes> kinks(static_cast<std::size_t>(polyhedron.rowCount), KinkLanes{splat(0), {}});
  QuaternionLanes climbed = rotations;
  const LaneMask certified = climbPolyhedral(lanes, PolyhedronRows(polyhedron), LaneMask{}, kinks, climbed).certified;
  const FanLayout layout = FanLayout::ofSingles(4);
  PolyhedralExact solver(polyhedron);
  solver.begin(layout);
  const Lanes regularizers = solver.solve(0, lanes, rotations);
  Solved result;
  for (int lane = 0; lane < 4; ++lane) {
    result.R[lane] = rotationAt(rotations, lane);
    result.regularizer[lane] = regularizers[lane];
    result.certified[lane] = certified[lane] != 0;
    result.pull[lane] = Vec3::Zero();
    for (Index j = 0; j < polyhedron.rowCount; ++j) {
      const double subgradient = std::clamp<double>(kinks[j].u[lane], -1, 1);
      result.pull[lane] += polyhedron.lengths[j] * subgradient * polyhedron.rows[j];
    }
  }
  return result;
}

void solveByAdmm(const CubicAdmm& admm, const PolyhedralVertex& vertex, Mat3& R) {
  const FanNormal normal{vertex.n, vertex.weight};
  CubicAdmm::State state;
  admm.solve(vertex.M, {&normal, 1}, {&state, 1}, R);
}

double bruteForce(Noise& noise, const PolyhedralVertex& vertex) {
  Mat3 best = fitRotation(vertex.M);
  const auto offer = [&](const Mat3& R) {
    if (vertex.objective(R) > vertex.objective(best)) best = R;
  };
  for (int trial = 0; trial < 150; ++trial) offer(noise.rotation());
  for (double angle = 1; angle > 1e-4; angle *= 0.93) {
    const Mat3 turn = Eigen::AngleAxisd(angle, noise.direction()).toRotationMatrix();
    offer(turn * best);
  }
  return vertex.objective(best);
}

/// A matrix B of one's own: rows of unlike lengths, some of them parallel, all in one plane now and then.
Polyhedron someMatrix(Noise& noise, Index rowCount) {
  Points rows(rowCount, 3);
  const bool isFlat = noise() > 0.6;
  for (Index j = 0; j < rowCount; ++j) {
    Vec3 row = noise.direction() * (1.05 + noise());
    if (isFlat) row.z() = 0;
    if (j > 0 && noise() > 0.8) row = -0.5 * rows.row(0).transpose();
    rows.row(j) = row.transpose();
  }
  return Polyhedron::ofRows(rows);
}

double supportOf(const Polyhedron& polyhedron) {
  double sum = 0;
  for (Index j = 0; j < polyhedron.rowCount; ++j) sum += polyhedron.lengths[j];
  return sum;
}

/// Mean angle between face normals and the nearest face normal of a style, area-weighted, in degrees.
double angleTo(const std::vector<Vec3>& faces, const Points& positions, const Triangles& triangles) {
  double sum = 0, area = 0;
  for (Index f = 0; f < triangles.rows(); ++f) {
    const Vec3 a = positions.row(triangles(f, 0)).transpose(), b = positions.row(triangles(f, 1)).transpose(),
               c = positions.row(triangles(f, 2)).transpose();
    const Vec3 n = (b - a).cross(c - a);
    double cosine = 0;
    for (const Vec3& face : faces) cosine = std::max(cosine, std::abs(face.dot(n)) / n.norm());
    sum += n.norm() * std::acos(std::min(1.0, cosine));
    area += n.norm();
  }
  return sum / area * 180 / EIGEN_PI;
}

/// The faces of a zonotope stand across every pair of its edges.
std::vector<Vec3> faceNormals(const Polyhedron& polyhedron) {
  std::vector<Vec3> normals;
  for (Index i = 0; i < polyhedron.rowCount; ++i) {
    for (Index j = 0; j < i; ++j) normals.push_back(polyhedron.rows[i].cross(polyhedron.rows[j]).normalized());
  }
  return normals;
}

}  // namespace

TEST_CASE("the polyhedra are what their names say") {
  using Name = Polyhedron::Name;
  const std::map<Name, std::size_t> faces = {{Name::cube, 3},
                                             {Name::hexagonalPrism, 4},
                                             {Name::rhombicDodecahedron, 6},
                                             {Name::truncatedOctahedron, 7}};  // pairs of opposite ones
  for (const auto& choice : Polyhedron::names()) {
    const Polyhedron polyhedron = Polyhedron::named(choice.second);
    double length = 0;
    for (Index j = 0; j < polyhedron.rowCount; ++j) {
      length += polyhedron.lengths[j];
      CHECK(polyhedron.rows[j].norm() == doctest::Approx(1));
    }
    CHECK(length == doctest::Approx(3));
    std::vector<Vec3> distinct;
    for (const Vec3& n : faceNormals(polyhedron)) {
      const auto same = [&](const Vec3& other) { return std::abs(other.dot(n)) > 1 - 1e-9; };
      if (std::none_of(distinct.begin(), distinct.end(), same)) distinct.push_back(n);
    }
    CHECK(distinct.size() == faces.at(choice.second));
  }
}

TEST_CASE("brute force and a tight ADMM never beat the exact step of any polyhedron") {
  Noise noise;
  for (const auto& choice : Polyhedron::names()) {
    const Polyhedron polyhedron = Polyhedron::named(choice.second);
    const CubicAdmm admm(polyhedron, {1e-12, 1e-10, 1e-10, 20000});
    for (const double lambda : {0.05, 0.3, 1.0, 2.0, 5.5}) {
      int certified = 0;
      for (int trial = 0; trial < 12; ++trial) {
        std::vector<PolyhedralVertex> vertices;
        for (int lane = 0; lane < 4; ++lane) vertices.push_back(surfaceVertex(noise, lambda, polyhedron));
        const Solved solved = solve(vertices, polyhedron);
        for (int lane = 0; lane < 4; ++lane) {
          const PolyhedralVertex& vertex = vertices[lane];
          const double value = vertex.objective(solved.R[lane]), slack = kSingle * scaleOf(vertex);
          REQUIRE(solved.R[lane].determinant() == doctest::Approx(1));
          REQUIRE(bruteForce(noise, vertex) <= value + slack);
          REQUIRE(vertex.objective(searchCubic(vertex, Mat3::Identity())) <= value + slack);
          Mat3 R = fitRotation(vertex.M);
          solveByAdmm(admm, vertex, R);
          REQUIRE(vertex.objective(R) <= value + slack);
          REQUIRE(std::abs(solved.regularizer[lane] - vertex.weight * polyhedron.support(solved.R[lane] * vertex.n)) <=
                  slack);
          certified += solved.certified[lane];
        }
      }
      INFO(choice.first);
      CAPTURE(lambda);
      if (lambda <= 2) CHECK(certified >= 44);
    }
  }
}

TEST_CASE("any matrix B: no gap where it is certified, and neither brute force nor a tight ADMM is better anywhere") {
  Noise noise;
  for (Index rowCount = 1; rowCount <= Polyhedron::kMostRows; ++rowCount) {
    int certified = 0, count = 0;
    for (int trial = 0; trial < 20; ++trial) {
      const Polyhedron polyhedron = someMatrix(noise, rowCount);
      const double lambda = (trial % 4 == 3 ? 15.0 : 1.0) / supportOf(polyhedron);
      const CubicAdmm admm(polyhedron, {1e-10, 1e-8, 1e-8, 4000});
      std::vector<PolyhedralVertex> vertices;
      for (int lane = 0; lane < 4; ++lane) vertices.push_back(surfaceVertex(noise, lambda, polyhedron));
      const Solved solved = solve(vertices, polyhedron);
      for (int lane = 0; lane < 4; ++lane) {
        const PolyhedralVertex& vertex = vertices[lane];
        const double value = vertex.objective(solved.R[lane]), slack = kSingle * scaleOf(vertex);
        REQUIRE(std::abs(solved.regularizer[lane] - vertex.weight * polyhedron.support(solved.R[lane] * vertex.n)) <=
                slack);
        REQUIRE(bruteForce(noise, vertex) <= value + slack);
        Mat3 R = fitRotation(vertex.M);
        solveByAdmm(admm, vertex, R);
        REQUIRE(vertex.objective(R) <= value + slack);
        if (trial % 4 == 3) continue;
        ++count;
        if (!solved.certified[lane]) continue;
        ++certified;
        const Mat3 pulled = vertex.M - vertex.weight * vertex.n * solved.pull[lane].transpose();
        REQUIRE(fitRotation(pulled).cwiseProduct(pulled.transpose()).sum() <= value + slack);
      }
    }
    CAPTURE(rowCount);
    CHECK(certified >= 0.9 * count);
  }
}

TEST_CASE("a box of any edges, some of them none: the cube's step, the search and a tight ADMM agree") {
  Noise noise;
  for (const Vec3& lengths : {Vec3(1, 1, 0.1), Vec3(1, 0.3, 2), Vec3(1, 1, 0), Vec3(0, 0, 1), Vec3(0, 2, 0.5)}) {
    const Polyhedron box = Polyhedron::box(lengths);
    const CubicAdmm admm(box, {1e-12, 1e-10, 1e-10, 20000});
    for (const double lambda : {0.05, 0.4, 1.0, 2.5}) {
      for (int trial = 0; trial < 12; ++trial) {
        const PolyhedralVertex vertex = surfaceVertex(noise, lambda, box);
        const CubicVertex cubic{vertex.M, vertex.n, lambda * lengths};
        Mat3 exact = fitRotation(vertex.M), R = exact;
        Vec3 u = Vec3::Zero();
        CubicExact::solveCertified(cubic, u, exact);
        const double value = cubic.objective(exact), scale = scaleOf(vertex);
        REQUIRE(vertex.objective(exact) == doctest::Approx(value).epsilon(1e-12));
        REQUIRE(bruteForce(noise, vertex) <= value + 1e-10 * scale);
        REQUIRE(vertex.objective(searchCubic(vertex, Mat3::Identity())) == doctest::Approx(value).epsilon(1e-9));
        solveByAdmm(admm, vertex, R);
        REQUIRE(vertex.objective(R) <= value + 1e-10 * scale);
      }
    }
  }
}

TEST_CASE("a sphere takes on the faces of each polyhedron, with falling energy") {
  const TriangleMesh mesh = sphere(4);
  for (const auto& choice : Polyhedron::names()) {
    const std::vector<Vec3> faces = faceNormals(Polyhedron::named(choice.second));
    for (const char* localStep : {"exact", "admm"}) {
      Session session;
      REQUIRE(session.load(mesh).ok());
      REQUIRE(session.select("cubic").ok());
      REQUIRE(session.set("lambda", encoded(0.5)).ok());
      REQUIRE(session.set("polyhedron", encoded(choice.first)).ok());
      REQUIRE(session.set("localStep", encoded(localStep)).ok());
      REQUIRE(session.set("maxIterations", encoded(60)).ok());
      REQUIRE(session.prepare().ok());
      StepReport report;
      double before = std::numeric_limits<double>::infinity();
      do {
        REQUIRE(session.step(report).ok());
        REQUIRE(report.energy <= before * (1 + 1e-8));
        before = report.energy;
      } while (report.outcome == Outcome::running);
      Points positions(mesh.vertexCount(), 3);
      session.copyPositions(positions.data());
      INFO(choice.first);
      CHECK(angleTo(faces, positions, mesh.triangles) < 0.6 * angleTo(faces, mesh.positions, mesh.triangles));
    }
  }
}
