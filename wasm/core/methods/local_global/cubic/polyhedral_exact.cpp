#include "methods/local_global/cubic/polyhedral_exact.h"

#include <cmath>
#include <iterator>

#include "geometry/rotation_fit.h"
#include "methods/local_global/cubic/cubic_search.h"

namespace whittle {

namespace {

/// Turns of the fit from where the climbs of a search start: about the axes of a cube, of a vertex's first search about
/// its diagonals too, by 0.67 radians each way. With all of them brute force finds nothing better at 600 random corners
/// up to λ 4.
constexpr float kAlong = 0.7f, kAcross = 0.40415f;
constexpr struct {
  float x, y, z;
} kTurns[] = {{kAlong, 0, 0},
              {-kAlong, 0, 0},
              {0, kAlong, 0},
              {0, -kAlong, 0},
              {0, 0, kAlong},
              {0, 0, -kAlong},
              {kAcross, kAcross, kAcross},
              {kAcross, kAcross, -kAcross},
              {kAcross, -kAcross, kAcross},
              {kAcross, -kAcross, -kAcross},
              {-kAcross, kAcross, kAcross},
              {-kAcross, kAcross, -kAcross},
              {-kAcross, -kAcross, kAcross},
              {-kAcross, -kAcross, -kAcross}};
constexpr std::size_t kAxisTurns = 6;

}  // namespace

void PolyhedralExact::begin(const FanLayout& layout) {
  layout_ = &layout;
  kinks_.assign(layout.slotCount() * rows_.size(), KinkLanes{splat(0), {}});
  attempt_.resize(static_cast<std::size_t>(layout.most) * rows_.size());
  normals_.resize(static_cast<std::size_t>(layout.most));
  schedule_.begin(layout.batchCount());
}

Lanes PolyhedralExact::solve(std::size_t batch, const CubicLanes& vertices, QuaternionLanes& rotations) {
  const std::size_t first = static_cast<std::size_t>(layout_->start[batch]) * rows_.size();
  const std::span<KinkLanes> kinks{&kinks_[first], vertices.fans.size() * rows_.size()};
  const QuaternionLanes before = rotations;
  const LaneMask known = schedule_.open(batch);
  auto [regularizers, certified, settled] = climbPolyhedral(vertices, rows_, known, kinks, rotations);
  if (all(certified)) return regularizers;
  regularizers = select(settled, regularizers, rows_.regularizers(vertices, rotations));
  takeBetter(vertices.M, before, rows_.regularizers(vertices, before), rotations, regularizers);
  const LaneMask due = schedule_.due(batch, certified);
  if (!any(due)) return regularizers;

  const LaneMask paid = vertices.fans.size() == 1 ? search(vertices, due, before, kinks, rotations, regularizers)
                                                  : climbAgain(vertices, due, known, kinks, rotations, regularizers);
  for (int lane = 0; lane < 4; ++lane) {
    if (due[lane]) schedule_.searched(batch, lane, paid[lane] != 0);
  }
  return regularizers;
}

LaneMask PolyhedralExact::search(const CubicLanes& vertices, LaneMask lanes, const QuaternionLanes& before,
                                 std::span<KinkLanes> kinks, QuaternionLanes& rotations, Lanes& regularizers) {
  QuaternionLanes found = rotations;
  for (int lane = 0; lane < 4; ++lane) {
    if (!lanes[lane]) continue;
    const FanNormal normal = normalsAt(vertices, lane, normals_)[0];
    const PolyhedralVertex vertex(matrixAt(vertices.M, lane), normal.n, normal.weight, polyhedron_);
    const Mat3 R = vertex.weight == 0 ? fitRotation(vertex.M) : searchCubic(vertex, rotationAt(before, lane));
    setRotation(found, lane, R);
    for (Index j = 0; j < polyhedron_.rowCount; ++j) {
      const double side = polyhedron_.rows[j].dot(R * vertex.n);
      kinks[j].u[lane] = std::abs(side) < 1e-6 ? 0 : std::copysign(1.0f, static_cast<float>(side));
    }
  }
  const Lanes ofFound = rows_.regularizers(vertices, found);
  const LaneMask paid = takeBetter(vertices.M, found, ofFound, rotations, regularizers);
  rotations = select(lanes, found, rotations);
  regularizers = select(lanes, ofFound, regularizers);
  return paid;
}

LaneMask PolyhedralExact::climbAgain(const CubicLanes& vertices, LaneMask lanes, LaneMask known,
                                     std::span<KinkLanes> kinks, QuaternionLanes& rotations, Lanes& regularizers) {
  QuaternionLanes fits = rotations;
  for (int lane = 0; lane < 4; ++lane) {
    if (lanes[lane]) setRotation(fits, lane, fitRotation(matrixAt(vertices.M, lane)));
  }
  LaneMask paid{};
  const std::span<KinkLanes> attempt{attempt_.data(), kinks.size()};
  const auto climbFrom = [&](QuaternionLanes start) {
    for (KinkLanes& kink : attempt) kink.u = splat(0);
    climbPolyhedral(vertices, rows_, ~LaneMask{}, attempt, start);
    const LaneMask better = takeBetter(vertices.M, start, rows_.regularizers(vertices, start), rotations, regularizers);
    for (std::size_t i = 0; i < kinks.size(); ++i) kinks[i].u = select(better, attempt[i].u, kinks[i].u);
    paid |= better;
  };
  climbFrom(fits);
  const std::size_t count = any(lanes & ~known) ? std::size(kTurns) : kAxisTurns;
  for (std::size_t i = 0; i < count; ++i)
    climbFrom(turned(fits, {splat(kTurns[i].x), splat(kTurns[i].y), splat(kTurns[i].z)}));
  return paid;
}

}  // namespace whittle
