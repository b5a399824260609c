// Its twin in double precision, which searches all there is, for any polyhedron: cubic_search.cpp.
#include "methods/local_global/cubic/search_lanes.h"

#include <cmath>

namespace whittle {

namespace {

/// The objective as a function of the turned normal s alone: the turn about s that is left has its best angle in closed
/// form. m · s + √(tr N − s · N s + 2 c · s) − κ · |s| with m = Mᵀ n, N = Mᵀ (I − n nᵀ) M and c = cof(Mᵀ) n.
struct NormalObjectiveLanes {
  VectorLanes m, c;
  SymmetricLanes N;
  Lanes trace;

  NormalObjectiveLanes(const MatrixLanes& M, const VectorLanes& n) {
    const VectorLanes rows[] = {
        {M.m[0][0], M.m[0][1], M.m[0][2]}, {M.m[1][0], M.m[1][1], M.m[1][2]}, {M.m[2][0], M.m[2][1], M.m[2][2]}};
    m = n.x * rows[0] + n.y * rows[1] + n.z * rows[2];
    c = n.x * cross(rows[1], rows[2]) + n.y * cross(rows[2], rows[0]) + n.z * cross(rows[0], rows[1]);
    const Lanes none = splat(0);
    N = plusOuter({none, none, none, none, none, none}, splat(-1), m);
    for (const VectorLanes& row : rows) N = plusOuter(N, splat(1), row);
    trace = N.xx + N.yy + N.zz;
  }
};

/// The best point so far of each lane.
struct BestLanes {
  VectorLanes s;
  Lanes value = splat(-INFINITY);

  void offer(Lanes candidate, const VectorLanes& at) {
    const LaneMask better = candidate > value;
    s = select(better, at, s);
    value = select(better, candidate, value);
  }
};

/// A great circle in the plane of two axes p and q: what the objective and the weights have there.
struct Circle {
  Lanes mp, mq, cp, cq, pp, pq, qq, weightP, weightQ, trace;

  Lanes at(float p, float q) const {
    const Lanes inPlane = trace - (p * p * pp + 2 * p * q * pq + q * q * qq) + 2.0f * (p * cp + q * cq);
    return p * mp + q * mq + squareRoot(maximum(inPlane, splat(0))) - (std::abs(p) * weightP + std::abs(q) * weightQ);
  }
};

/// Points of a quarter of a circle, the first of them on an axis.
constexpr float kPoints[][2] = {{1, 0}, {0.8660254f, 0.5f}, {0.5f, 0.8660254f}};

template <typename Place>
void sampleCircle(const Circle& circle, Place place, BestLanes& best) {
  for (const auto& [along, across] : kPoints) {
    const float turns[][2] = {{along, across}, {-across, along}, {-along, -across}, {across, -along}};
    for (const auto& [p, q] : turns) best.offer(circle.at(p, q), place(splat(p), splat(q)));
  }
}

/// The shortest rotation from one unit vector to another.
QuaternionLanes between(const VectorLanes& from, const VectorLanes& to) {
  const Lanes none = splat(0);
  const LaneMask isOpposite = dot(from, to) < -0.999f;
  const VectorLanes flat =
      select(absolute(from.z) < 0.7f, VectorLanes{-from.y, from.x, none}, VectorLanes{none, -from.z, from.y});
  const VectorLanes axis = select(isOpposite, flat, cross(from, to));
  return normalized({select(isOpposite, none, 1 + dot(from, to)), axis.x, axis.y, axis.z});
}

/// The rotation about s by the angle that leaves most of tr(R A).
QuaternionLanes bestTurnAbout(const VectorLanes& s, const MatrixLanes& A) {
  const auto& m = A.m;
  const VectorLanes g{m[1][2] - m[2][1], m[2][0] - m[0][2], m[0][1] - m[1][0]};
  const Lanes across = dot(s, g), along = trace(A) - dot(s, A * s);
  const Lanes length = squareRoot(along * along + across * across);
  const Lanes cosine = select(length > 0, along / length, splat(1));
  const Lanes sine = withSign(squareRoot(maximum(0.5f - 0.5f * cosine, splat(0))), across);
  return {squareRoot(maximum(0.5f + 0.5f * cosine, splat(0))), sine * s.x, sine * s.y, sine * s.z};
}

}  // namespace

QuaternionLanes searchLanes(const MatrixLanes& M, const VectorLanes& n, const VectorLanes& weights,
                            const QuaternionLanes& rotations) {
  const auto [m, c, N, trace] = NormalObjectiveLanes(M, n);
  const Lanes none = splat(0);
  BestLanes best;
  sampleCircle(
      {m.x, m.y, c.x, c.y, N.xx, N.xy, N.yy, weights.x, weights.y, trace},
      [&](Lanes p, Lanes q) -> VectorLanes {
        return {p, q, none};
      },
      best);
  sampleCircle(
      {m.y, m.z, c.y, c.z, N.yy, N.yz, N.zz, weights.y, weights.z, trace},
      [&](Lanes p, Lanes q) -> VectorLanes {
        return {none, p, q};
      },
      best);
  sampleCircle(
      {m.x, m.z, c.x, c.z, N.xx, N.xz, N.zz, weights.x, weights.z, trace},
      [&](Lanes p, Lanes q) -> VectorLanes {
        return {p, none, q};
      },
      best);
  const QuaternionLanes there = between(toMatrix(rotations) * n, best.s) * rotations;
  return normalized(bestTurnAbout(best.s, toMatrix(there) * M) * there);
}

}  // namespace whittle
