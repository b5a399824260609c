#include "simd/symmetric_eigen.h"

#include <utility>

namespace whittle {

namespace {

constexpr int kMostSweeps = 6;  // three or four do
/// Entries off the diagonal that no longer matter, as a share of the trace.
constexpr float kNegligible = 1e-7f;

/// Turns by the angle that makes the entry pq zero; r is the third axis.
void rotate(Lanes& pp, Lanes& pq, Lanes& qq, Lanes& pr, Lanes& qr, VectorLanes& p, VectorLanes& q) {
  const Lanes difference = qq - pp, twice = pq + pq;
  const Lanes size = squareRoot(difference * difference + twice * twice);
  const LaneMask isDiagonal = size == splat(0);
  const Lanes below = difference + withSign(size, difference);
  const Lanes tangent = select(isDiagonal, splat(0), twice / select(isDiagonal, splat(1), below));
  const Lanes cosine = splat(1) / squareRoot(splat(1) + tangent * tangent), sine = tangent * cosine;
  pp -= tangent * pq;
  qq += tangent * pq;
  pq = splat(0);
  const Lanes before = pr;
  pr = cosine * before - sine * qr;
  qr = sine * before + cosine * qr;
  const VectorLanes vector = p;
  p = cosine * vector - sine * q;
  q = sine * vector + cosine * q;
}

void sortPair(EigenLanes& eigen, int first, int second) {
  const LaneMask swap = eigen.values[first] < eigen.values[second];
  const Lanes value = eigen.values[first];
  const VectorLanes vector = eigen.vectors[first];
  eigen.values[first] = select(swap, eigen.values[second], value);
  eigen.values[second] = select(swap, value, eigen.values[second]);
  eigen.vectors[first] = select(swap, eigen.vectors[second], vector);
  eigen.vectors[second] = select(swap, vector, eigen.vectors[second]);
}

}  // namespace

EigenLanes eigenDecomposition(SymmetricLanes A) {
  const Lanes one = splat(1), none = splat(0);
  EigenLanes eigen{{}, {{one, none, none}, {none, one, none}, {none, none, one}}};
  VectorLanes &x = eigen.vectors[0], &y = eigen.vectors[1], &z = eigen.vectors[2];
  const Lanes negligible = splat(kNegligible) * (absolute(A.xx) + absolute(A.yy) + absolute(A.zz));
  for (int sweep = 0; sweep < kMostSweeps; ++sweep) {
    if (all(absolute(A.xy) + absolute(A.xz) + absolute(A.yz) <= negligible)) break;
    rotate(A.xx, A.xy, A.yy, A.xz, A.yz, x, y);
    rotate(A.xx, A.xz, A.zz, A.xy, A.yz, x, z);
    rotate(A.yy, A.yz, A.zz, A.xy, A.xz, y, z);
  }
  eigen.values[0] = A.xx, eigen.values[1] = A.yy, eigen.values[2] = A.zz;
  for (const auto& [first, second] : {std::pair{0, 1}, {1, 2}, {0, 1}}) sortPair(eigen, first, second);
  return eigen;
}

}  // namespace whittle
