#pragma once

#include <cstdint>

namespace whittle {

/// A point of a lattice of 2²⁰ places along each axis. On it, predicates are exact in whole numbers: regular grids and
/// points on one sphere, which are the rule in meshes, need no tolerance.
struct LatticePoint {
  static constexpr int kBits = 20;

  std::int32_t x, y, z;  // 0 … 2²⁰ − 1

  /// Its place along the Z curve, 60 bits: near places are mostly near in space, and no two points share one.
  std::uint64_t key() const {
    const auto spread = [](std::uint64_t bits) {  // two free bits after each
      bits = (bits | bits << 32) & 0x1f00000000ffffu;
      bits = (bits | bits << 16) & 0x1f0000ff0000ffu;
      bits = (bits | bits << 8) & 0x100f00f00f00f00fu;
      bits = (bits | bits << 4) & 0x10c30c30c30c30c3u;
      return (bits | bits << 2) & 0x1249249249249249u;
    };
    return spread(static_cast<std::uint32_t>(x)) | spread(static_cast<std::uint32_t>(y)) << 1 |
           spread(static_cast<std::uint32_t>(z)) << 2;
  }
};

namespace detail {

/// From one point to another; components below 2²⁰ in magnitude.
struct LatticeStep {
  std::int64_t x, y, z;

  LatticeStep(const LatticePoint& from, const LatticePoint& to)
      : x(std::int64_t{to.x} - from.x), y(std::int64_t{to.y} - from.y), z(std::int64_t{to.z} - from.z) {}
  std::int64_t squaredLength() const { return x * x + y * y + z * z; }  // < 2⁴²
};

/// x and y of two steps: < 2⁴¹.
inline std::int64_t crossed(const LatticeStep& a, const LatticeStep& b) { return a.x * b.y - b.x * a.y; }

}  // namespace detail

/// Six times the volume of a tetrahedron, positive where a, b, c run counterclockwise as seen from d's far side. It
/// stays below 2⁶³.
inline std::int64_t orientation(const LatticePoint& a, const LatticePoint& b, const LatticePoint& c,
                                const LatticePoint& d) {
  const detail::LatticeStep da(d, a), db(d, b), dc(d, c);
  return da.z * crossed(db, dc) - db.z * crossed(da, dc) + dc.z * crossed(da, db);
}

/// Whether e lies within the sphere through four points of positive orientation, and not on it.
inline bool isInSphere(const LatticePoint& a, const LatticePoint& b, const LatticePoint& c, const LatticePoint& d,
                       const LatticePoint& e) {
  const detail::LatticeStep ea(e, a), eb(e, b), ec(e, c), ed(e, d);
  const std::int64_t ab = crossed(ea, eb), bc = crossed(eb, ec), cd = crossed(ec, ed), da = crossed(ed, ea),
                     ac = crossed(ea, ec), bd = crossed(eb, ed);
  const std::int64_t abc = ea.z * bc - eb.z * ac + ec.z * ab, bcd = eb.z * cd - ec.z * bd + ed.z * bc,
                     cda = ec.z * da + ed.z * ac + ea.z * cd, dab = ed.z * ab + ea.z * bd + eb.z * da;  // < 2⁶³
  using Wide = __int128;  // of terms below 2¹⁰⁵
  return static_cast<Wide>(ed.squaredLength()) * abc - static_cast<Wide>(ec.squaredLength()) * dab +
             static_cast<Wide>(eb.squaredLength()) * cda - static_cast<Wide>(ea.squaredLength()) * bcd >
         0;
}

}  // namespace whittle
