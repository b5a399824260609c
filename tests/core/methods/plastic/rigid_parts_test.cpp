// What parts of a shell may do as they are: what held points leave them, how they are aligned, and systems of parts that float.
#include <doctest/doctest.h>

#include <cmath>

#include "methods/plastic/alignment.h"
#include "methods/plastic/held_points.h"
#include "methods/plastic/shell_system.h"
#include "support/shapes.h"

using namespace whittle;
using namespace whittle::testing;

namespace {

using Rank = HeldPoints::Rank;

const std::vector<Vec3> kPoints = {{1, 0, 0}, {0, 2, 0}, {0, 0, 3}, {1, 1, -2}};

std::vector<Vec3> moved(const std::vector<Vec3>& points, const RigidMotion& motion) {
  std::vector<Vec3> result;
  for (const Vec3& point : points) result.push_back(motion(point));
  return result;
}

double farthestOff(const RigidMotion& motion, const std::vector<Vec3>& points, const std::vector<Vec3>& targets) {
  double off = 0;
  for (std::size_t i = 0; i < points.size(); ++i) off = std::max(off, (motion(points[i]) - targets[i]).norm());
  return off;
}

/// Two balls, of which some vertices are held.
struct TwoBalls {
  TriangleMesh mesh = together(bent(sphere(2)), bent(sphere(2)), Vec3(4, 0, 0));
  Components parts = connectedComponents(mesh.triangles, mesh.vertexCount());
  std::vector<Index> nodeOf;
  RigidModes modes;
  Shell shell;

  explicit TwoBalls(const std::vector<Index>& held) : nodeOf(mesh.vertexCount(), 0) {
    for (const Index v : held) nodeOf[v] = -1;
    Index nodes = 0;
    for (Index& node : nodeOf) node = node < 0 ? -1 : nodes++;
    modes.find(mesh.positions, parts, nodeOf);
    shell.setRest(mesh, {0.1, 0.3});
  }
};

}  // namespace

TEST_CASE("held points are none, a point, a line or a plane") {
  CHECK(HeldPoints({}).rank == Rank::none);
  CHECK(HeldPoints({{1, 2, 3}}).rank == Rank::point);
  CHECK(HeldPoints({{1, 2, 3}, {1, 2, 3}}).rank == Rank::point);
  CHECK(HeldPoints({{1, 2, 3}, {2, 3, 4}, {4, 5, 6}}).rank == Rank::line);
  CHECK(HeldPoints({{1, 2, 3}, {2, 3, 4}, {4, 5, 7}}).rank == Rank::plane);
}

TEST_CASE("a part is aligned as far as what is held lets it") {
  const RigidMotion whole{someRotation(), Vec3(1, 2, 3), Vec3(-4, 0, 2)};
  CHECK(farthestOff(alignment({}, kPoints, moved(kPoints, whole)), kPoints, moved(kPoints, whole)) < 1e-12);

  const Vec3 anchor(2, -1, 0.5);
  const RigidMotion about{someRotation(), anchor, Vec3::Zero()};
  const RigidMotion found = alignment({anchor}, kPoints, moved(kPoints, about));
  CHECK((found(anchor) - anchor).norm() < 1e-14);
  CHECK(farthestOff(found, kPoints, moved(kPoints, about)) < 1e-12);

  const Vec3 axis = Vec3(1, 2, -1).normalized();
  const RigidMotion hinge{Eigen::AngleAxisd(2.5, axis).toRotationMatrix(), anchor, Vec3::Zero()};
  const RigidMotion turned = alignment({anchor, anchor + axis}, kPoints, moved(kPoints, hinge));
  CHECK((turned(anchor + 3 * axis) - anchor - 3 * axis).norm() < 1e-13);
  CHECK(farthestOff(turned, kPoints, moved(kPoints, hinge)) < 1e-12);

  const RigidMotion still = alignment({anchor, anchor + axis, Vec3(7, 7, 0)}, kPoints, moved(kPoints, whole));
  CHECK(farthestOff(still, kPoints, kPoints) == 0);
}

TEST_CASE("what landmarks leave open of a turn is not turned") {
  const RigidMotion shifted = alignment({}, {Vec3(1, 0, 0)}, {Vec3(3, 1, 0)});
  CHECK((shifted.turn - Mat3::Identity()).norm() == 0);
  CHECK((shifted(Vec3(1, 0, 0)) - Vec3(3, 1, 0)).norm() < 1e-14);
  const RigidMotion swung = alignment({}, {Vec3(1, 0, 0), Vec3(-1, 0, 0)}, {Vec3(0, 2, 0), Vec3(0, -2, 0)});
  CHECK((swung.turn * Vec3::UnitX() - Vec3::UnitY()).norm() < 1e-12);
  CHECK((swung.turn * Vec3::UnitZ() - Vec3::UnitZ()).norm() < 1e-12);
}

TEST_CASE("each part floats by what its own held vertices leave") {
  const Index second = sphere(2).vertexCount();
  CHECK(TwoBalls({}).modes.count() == 12);
  CHECK(TwoBalls({3}).modes.count() == 9);
  CHECK(TwoBalls({3, 9}).modes.count() == 7);
  CHECK(TwoBalls({3, 9, 17}).modes.count() == 6);
  CHECK(TwoBalls({3, 9, 17, second}).modes.count() == 3);
}

TEST_CASE("rigid motion is taken out of displacements, and nothing else") {
  TwoBalls balls({3});
  Noise noise;
  RigidModes::Rows motion(3 * (balls.mesh.vertexCount() - 1), 1), other = motion;
  for (Index v = 0; v < balls.mesh.vertexCount(); ++v) {
    if (balls.nodeOf[v] >= 0)
      motion.middleRows(3 * balls.nodeOf[v], 3) = balls.modes.velocities(v) * Scalars::LinSpaced(9, 1, 9);
  }
  for (Index i = 0; i < other.size(); ++i) other.data()[i] = noise();
  balls.modes.takeOut(other);
  RigidModes::Rows both = motion + other;
  balls.modes.takeOut(both);
  CHECK((both - other).norm() < 1e-12 * motion.norm());
}

TEST_CASE("parts are moved by finite turns, which strain nothing") {
  TwoBalls balls({3});
  Points positions = balls.mesh.positions;
  balls.modes.move(Scalars::LinSpaced(9, -5, 9), 1, positions);
  CHECK((positions - balls.mesh.positions).rowwise().norm().maxCoeff() > 0.5);
  CHECK((positions.row(3) - balls.mesh.positions.row(3)).norm() == 0);
  balls.shell.setShape(positions);
  CHECK(balls.shell.energy() < 1e-24);
}

TEST_CASE("the system of parts that float gives their displacements under forces in balance") {
  for (const std::vector<Index>& held : {std::vector<Index>{}, {3}, {3, 9}, {3, 9, 17}}) {
    TwoBalls balls(held);
    ShellSystem system;
    system.shape(balls.shell, balls.nodeOf);
    while (system.analyzeNext() < 1) {
    }
    system.beginFactorize(balls.shell, balls.modes);
    for (double share = 0; share < 1;) REQUIRE(system.factorizeNext(share).ok());
    Noise noise;
    ShellSystem::Rows load(system.unknowns(), 4);
    for (Index i = 0; i < load.size(); ++i) load.data()[i] = noise();
    balls.modes.takeOut(load);
    ShellSystem::Rows solution = load;
    REQUIRE(system.solve(solution).ok());
    Stiffness plain(balls.shell, balls.nodeOf);
    plain.assemble(balls.shell);
    const Eigen::MatrixXd K = Eigen::MatrixXd(plain.matrix()).selfadjointView<Eigen::Lower>();
    CHECK((K * solution - load).norm() < 1e-5 * load.norm());
    ShellSystem::Rows without = solution;
    balls.modes.takeOut(without);
    CHECK((without - solution).norm() < 1e-10 * solution.norm());
  }
}
