#include <doctest/doctest.h>

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <vector>

#include "geometry/surface.h"
#include "support/ablations.h"

using namespace whittle;
using namespace whittle::testing;

// What each term of the printed method is for: the same gesture with and without it (Fig. 6 and 14 of the paper).

namespace {

/// A ring of points about z, as the circle that they lie nearest to.
struct Ring {
  double radius, roundness;  // roundness: root mean square of the distances from it, as a share of the radius
};

Ring fittedRing(const Points& positions, const std::vector<Index>& on) {
  Eigen::MatrixX3d rows(static_cast<Index>(on.size()), 3);
  Eigen::VectorXd squares(rows.rows());
  for (Index i = 0; i < rows.rows(); ++i) {
    const double x = positions(on[i], 0), y = positions(on[i], 1);
    rows.row(i) << 2 * x, 2 * y, 1;
    squares[i] = x * x + y * y;
  }
  const Vec3 fit = rows.colPivHouseholderQr().solve(squares);
  const double radius = std::sqrt(fit[2] + fit.head<2>().squaredNorm());
  double sum = 0;
  for (const Index v : on) {
    const double off = std::hypot(positions(v, 0) - fit[0], positions(v, 1) - fit[1]) - radius;
    sum += off * off;
  }
  return {radius, std::sqrt(sum / static_cast<double>(on.size())) / radius};
}

/// How far the least round of a column’s rings is off a circle.
double offRound(const Ablation& ablation, const Points& positions) {
  const Points& rest = ablation.mesh.positions;
  double most = 0;
  for (const std::vector<Index>& ring : ringsOf(rest)) most = std::max(most, fittedRing(positions, ring).roundness);
  return most;
}

/// Mean distance of the ball's vertices from their middle over that at rest, and how far they are off it.
Ring ballOf(const Ablation& ablation, const Points& positions) {
  const std::vector<Index> on = ballVertices(ablation.mesh.positions);
  const auto meanRadius = [&](const Points& of, double& spread) {
    Vec3 middle = Vec3::Zero();
    for (const Index v : on) middle += of.row(v).transpose() / static_cast<double>(on.size());
    double sum = 0, squares = 0;
    for (const Index v : on) {
      const double radius = (of.row(v).transpose() - middle).norm();
      sum += radius;
      squares += radius * radius;
    }
    const double count = static_cast<double>(on.size()), mean = sum / count;
    spread = std::sqrt(std::max(0.0, squares / count - mean * mean)) / mean;
    return mean;
  };
  double spread = 0;
  const double before = meanRadius(ablation.mesh.positions, spread), after = meanRadius(positions, spread);
  return {after / before, spread};
}

struct Turns {
  double mean, most;  // degrees
};

Turns turnsOf(const Ablation& ablation, const Points& positions) {
  const Triangles& triangles = ablation.mesh.triangles;
  const Points before = faceNormals(ablation.mesh.positions, triangles), after = faceNormals(positions, triangles);
  Turns turns{0, 0};
  for (Index f = 0; f < before.rows(); ++f) {
    const double turn = std::acos(std::clamp(before.row(f).dot(after.row(f)), -1.0, 1.0)) * 180 / EIGEN_PI;
    turns.mean += turn / static_cast<double>(before.rows());
    turns.most = std::max(turns.most, turn);
  }
  return turns;
}

}  // namespace

TEST_CASE("without similarity a cylinder that is widened is no longer round (Fig. 6, above)") {
  const Ablation column = widenedColumn();
  const double whole = offRound(column, column.run("whole"));
  const double without = offRound(column, column.run("similarity"));
  CHECK(whole < 0.02);
  CHECK(without > 1.5 * whole);
}

TEST_CASE("without sphericity a ball between rods becomes long and thick (Fig. 6, below)") {
  const Ablation pawn = lengthenedPawn();
  const Ring whole = ballOf(pawn, pawn.run("whole"));
  const Ring without = ballOf(pawn, pawn.run("sphericity"));
  CHECK(whole.radius == doctest::Approx(1).epsilon(0.03));
  CHECK(whole.roundness < 0.002);
  CHECK(without.radius > 1.15);
  CHECK(without.roundness > 20 * whole.roundness);
}

TEST_CASE("without normals the sides of a bracket turn (Fig. 14, left)") {
  const Ablation bracket = pulledBracket();
  const Turns whole = turnsOf(bracket, bracket.run("whole"));
  const Turns without = turnsOf(bracket, bracket.run("normal"));
  CHECK(whole.most < 1);
  CHECK(without.most > 5);
  CHECK(without.mean > 20 * whole.mean);
}

TEST_CASE("without normals points leave dents in a column (Fig. 14, left)") {
  const Ablation column = widenedColumn();
  CHECK(turnsOf(column, column.run("whole")).most < 1);
  CHECK(turnsOf(column, column.run("normal")).most > 30);
}

TEST_CASE("where size counts more than normals, points leave dents as in Poisson deformation (Fig. 14, right)") {
  const Ablation bar = pulledBar();
  const Turns whole = turnsOf(bar, bar.run("whole"));
  CHECK(whole.most < 0.5);
  // The paper's factor of 1000 leaves the term far below that of normals: it changes next to nothing.
  CHECK(turnsOf(bar, bar.run("size ×1000")).most < 0.5);
  const Turns more = turnsOf(bar, bar.run("size"));
  CHECK(more.most > 15);
  CHECK(more.mean > 20 * whole.mean);
}
