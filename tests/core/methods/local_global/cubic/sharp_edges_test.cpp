// The cubic style on meshes with sharp edges, whose vertices have a normal for each smooth fan of their faces.
#include <doctest/doctest.h>

#include <cmath>

#include "geometry/rotation_fit.h"
#include "geometry/surface.h"
#include "methods/local_global/cubic/cubic_admm.h"
#include "methods/local_global/cubic/polyhedral_exact.h"
#include "support/allocations.h"
#include "support/shapes.h"
#include "support/style_runs.h"

using namespace whittle;
using namespace whittle::testing;

namespace {

constexpr double kSingle = 3e-6;  // of an objective's scale

/// A corner of a block or of nothing in particular: M as the faces around it make it, somewhat turned, bent and noisy.
struct Corner {
  Mat3 M = Mat3::Zero();
  std::vector<FanNormal> normals;

  Corner(Noise& noise, int fanCount, double lambda) {
    const Mat3 sides = noise.rotation();
    const bool isBlock = noise() > -0.5;
    for (int k = 0; k < fanCount; ++k) {
      const double area = 1 + 0.8 * noise();
      const Vec3 n = isBlock && k < 3 ? Vec3(sides.col(k)) : noise.direction();
      normals.push_back({n, lambda * area});
      M += 6 * area * (Mat3::Identity() - n * n.transpose());
    }
    const Mat3 bend = noise.matrix();
    M = M * Eigen::AngleAxisd(0.5 * noise(), noise.direction()).toRotationMatrix() + 0.3 * fanCount * bend;
  }

  double scale() const { return M.norm() + static_cast<double>(normals.size()) * normals[0].weight; }
};

/// Four corners with 1, 2, … normals as the product packs them.
struct Packed {
  MatrixLanes M;
  std::vector<FanLanes> fans;
  QuaternionLanes rotations;
  FanLayout layout = FanLayout::ofSingles(4);

  explicit Packed(const std::vector<Corner>& corners) {
    for (int lane = 0; lane < 4; ++lane) {
      const Corner& corner = corners[lane];
      setMatrix(M, lane, corner.M);
      setRotation(rotations, lane, fitRotation(corner.M));
      for (std::size_t k = 0; k < corner.normals.size(); ++k) {
        if (fans.size() <= k) fans.push_back({{splat(0), splat(0), splat(0)}, splat(0)});
        setVector(fans[k].n, lane, corner.normals[k].n);
        fans[k].weight[lane] = static_cast<float>(corner.normals[k].weight);
      }
    }
    layout.start[1] = layout.most = static_cast<Index>(fans.size());
  }
  CubicLanes lanes() const { return {M, fans}; }
};

std::vector<Corner> someCorners(Noise& noise, double lambda) {
  std::vector<Corner> corners;
  for (int fanCount = 1; fanCount <= 4; ++fanCount) corners.emplace_back(noise, fanCount, lambda);
  return corners;
}

/// The best of random rotations and of small turns of the best so far, and of those of the plain fit.
double bruteForce(Noise& noise, const FanVertex& vertex) {
  const auto climbed = [&](Mat3 best) {
    for (double angle = 1.5; angle > 1e-4; angle *= 0.95) {
      const Mat3 turn = Eigen::AngleAxisd(angle, noise.direction()).toRotationMatrix() * best;
      if (vertex.objective(turn) > vertex.objective(best)) best = turn;
    }
    return vertex.objective(best);
  };
  Mat3 random = noise.rotation();
  for (int trial = 0; trial < 150; ++trial) {
    const Mat3 R = noise.rotation();
    if (vertex.objective(R) > vertex.objective(random)) random = R;
  }
  return std::max(climbed(random), climbed(fitRotation(vertex.M)));
}

struct Cut {
  double before, after;
  Run run;
};

/// Mean angle between faces and the nearest axis, before and after `cubic`.
Cut cut(const TriangleMesh& mesh, double lambda, const char* localStep) {
  Session session;
  REQUIRE(session.load(mesh).ok());
  REQUIRE(session.select("cubic").ok());
  REQUIRE(session.set("lambda", encoded(lambda)).ok());
  REQUIRE(session.set("localStep", encoded(localStep)).ok());
  REQUIRE(session.prepare().ok());
  const GaussMap cube(cubeStyle());
  Cut result{angleToStyle(mesh.positions, mesh.triangles, cube), 0, finish(session)};
  result.after = angleToStyle(result.run.positions, mesh.triangles, cube);
  return result;
}

bool neverRises(const std::vector<double>& energies) {
  for (std::size_t i = 1; i < energies.size(); ++i) {
    if (energies[i] > energies[i - 1] * (1 + 1e-6)) return false;
  }
  return true;
}

std::vector<std::vector<std::array<int, 3>>> alignedBlocks() {
  return {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}},
          {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}, {2, 1, 0}},
          {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {2, 0, 0}, {2, 1, 0}, {2, 2, 0}}};
}

/// The L of two arms, a corner of it cut off.
TriangleMesh withCornerCut() {
  TriangleMesh mesh = blocks({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, 1);
  for (Index v = 0; v < mesh.vertexCount(); ++v) {
    if (mesh.positions.row(v) == Eigen::RowVector3d(2, 0, 1)) mesh.positions.row(v) << 1.9, 0.1, 0.9;
  }
  return mesh;
}

}  // namespace

TEST_CASE("of several normals brute force finds nothing better, and a tight ADMM does not either") {
  Noise noise;
  using Name = Polyhedron::Name;
  for (const Polyhedron& polyhedron :
       {Polyhedron::box(Vec3::Ones()), Polyhedron::box({1, 0.4, 0}), Polyhedron::named(Name::hexagonalPrism)}) {
    const CubicAdmm admm(polyhedron, {1e-12, 1e-10, 1e-10, 4000});
    for (const double lambda : {0.05, 0.3, 1.0, 2.0}) {
      int certified = 0;
      for (int trial = 0; trial < 12; ++trial) {
        const std::vector<Corner> corners = someCorners(noise, lambda);
        Packed packed(corners);
        std::vector<KinkLanes> kinks(packed.fans.size() * static_cast<std::size_t>(polyhedron.rowCount),
                                     KinkLanes{splat(0), {}});
        QuaternionLanes climbed = packed.rotations;
        const PolyhedronRows rows(polyhedron);
        const LaneMask proved = climbPolyhedral(packed.lanes(), rows, LaneMask{}, kinks, climbed).certified;
        PolyhedralExact solver(polyhedron);
        solver.begin(packed.layout);
        const Lanes regularizers = solver.solve(0, packed.lanes(), packed.rotations);
        for (int lane = 0; lane < 4; ++lane) {
          const FanVertex vertex{corners[lane].M, corners[lane].normals, polyhedron};
          const Mat3 R = rotationAt(packed.rotations, lane);
          const double value = vertex.objective(R), slack = kSingle * corners[lane].scale();
          REQUIRE(bruteForce(noise, vertex) <= value + slack);
          REQUIRE(std::abs(regularizers[lane] - polyhedron.regularizer(vertex.normals, R)) <= slack);
          std::vector<CubicAdmm::State> states(vertex.normals.size());
          Mat3 split = fitRotation(vertex.M);
          admm.solve(vertex.M, vertex.normals, states, split);
          REQUIRE(vertex.objective(split) <= value + slack);
          certified += proved[lane] != 0;
        }
      }
      CAPTURE(lambda);
      CHECK(certified >= 43);
    }
  }
}

TEST_CASE("a certificate of several normals has no duality gap") {
  Noise noise;
  const Polyhedron cube = Polyhedron::box(Vec3::Ones());
  for (int trial = 0; trial < 40; ++trial) {
    const std::vector<Corner> corners = someCorners(noise, 0.3 + 0.05 * trial);
    Packed packed(corners);
    std::vector<KinkLanes> kinks(3 * packed.fans.size(), KinkLanes{splat(0), {}});
    const LaneMask proved =
        climbPolyhedral(packed.lanes(), PolyhedronRows(cube), LaneMask{}, kinks, packed.rotations).certified;
    for (int lane = 0; lane < 4; ++lane) {
      if (!proved[lane]) continue;
      const Corner& corner = corners[lane];
      Mat3 pulled = corner.M;
      for (std::size_t k = 0; k < corner.normals.size(); ++k) {
        const auto& [n, weight] = corner.normals[k];
        const Vec3 u(kinks[3 * k].u[lane], kinks[3 * k + 1].u[lane], kinks[3 * k + 2].u[lane]);
        pulled -= weight * n * u.transpose();
      }
      const double bound = fitRotation(pulled).cwiseProduct(pulled.transpose()).sum();
      const FanVertex vertex{corner.M, corner.normals, cube};
      REQUIRE(bound <= vertex.objective(rotationAt(packed.rotations, lane)) + kSingle * corner.scale());
    }
  }
}

TEST_CASE("a warm step of several normals is no worse and allocates nothing, for any lambda") {
  Noise noise;
  const Polyhedron cube = Polyhedron::box(Vec3::Ones());
  for (const double lambda : {0.3, 3.0, 20.0}) {
    std::vector<Corner> corners = someCorners(noise, lambda);
    PolyhedralExact solver(cube);
    Packed packed(corners);
    solver.begin(packed.layout);
    for (int step = 0; step < 40; ++step) {
      for (int lane = 0; lane < 4; ++lane) {
        corners[lane].M += 0.05 * noise.matrix();
        setMatrix(packed.M, lane, corners[lane].M);
      }
      const QuaternionLanes before = packed.rotations;
      const long allocations = testing::allocationCount();
      solver.solve(0, packed.lanes(), packed.rotations);
      REQUIRE(testing::allocationCount() == allocations);
      for (int lane = 0; lane < 4; ++lane) {
        const FanVertex vertex{corners[lane].M, corners[lane].normals, cube};
        REQUIRE(vertex.objective(rotationAt(packed.rotations, lane)) >=
                vertex.objective(rotationAt(before, lane)) - kSingle * corners[lane].scale());
      }
    }
  }
}

TEST_CASE("blocks along the axes are at rest, to the bit") {
  for (const auto& cubes : alignedBlocks()) {
    for (const int across : {1, 2}) {
      const TriangleMesh mesh = blocks(cubes, across);
      for (const char* localStep : {"exact", "admm"}) {
        for (const double lambda : {0.05, 0.2, 0.4, 2.0, 10.0}) {
          const Cut result = cut(mesh, lambda, localStep);
          CHECK(result.run.positions == mesh.positions);
          CHECK(result.run.energies.size() <= 2);
        }
      }
    }
  }
}

TEST_CASE("a turned block turns back, and none of its edges bends") {
  TriangleMesh mesh = blocks({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, 2);
  const Mat3 turn = Eigen::AngleAxisd(0.3, Vec3(1, 2, 3).normalized()).toRotationMatrix();
  const Points upright = mesh.positions;
  mesh.positions = (upright * turn.transpose()).eval();
  for (const char* localStep : {"exact", "admm"}) {
    const Cut result = cut(mesh, 0.4, localStep);
    CHECK(result.after < 0.1);
    CHECK(neverRises(result.run.energies));
    const Eigen::RowVector3d shift = result.run.positions.row(0) - upright.row(0);
    CHECK((result.run.positions.rowwise() - shift - upright).cwiseAbs().maxCoeff() < 0.01);
  }
}

TEST_CASE("a hexagonal prism stays, prisms of few sides come no further from the axes, one cut corner is no harm") {
  for (const double lambda : {0.2, 0.4}) {
    CHECK(cut(prism(6, 0), lambda, "exact").after == doctest::Approx(12.7).epsilon(0.01));
    CHECK(cut(withCornerCut(), lambda, "exact").after < 1.5);
    int nearer = 0, count = 0;
    for (int sides = 5; sides <= 16; ++sides) {
      for (const double turn : {0.0, 0.297}) {
        const Cut result = cut(prism(sides, turn), lambda, "exact");
        CHECK(neverRises(result.run.energies));
        CHECK(result.after < result.before + 1.6);
        nearer += result.after <= result.before + 0.05;
        ++count;
      }
    }
    CHECK(nearer >= count * 5 / 6);
  }
}
