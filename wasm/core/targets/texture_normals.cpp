#include "targets/texture_normals.h"

#include <cmath>
#include <vector>

#include "geometry/surface.h"

namespace whittle {

namespace {

using Pair = Eigen::Vector2d;

/// Share of their squared size below which the texture coordinates of a face span no area.
constexpr double kNoSpread = 1e-7;

/// How the texture lies on a face.
struct Spread {
  Vec3 alongU = Vec3::Zero();  // of any length; zero where there is none
  double handedness = 1;       // −1 if it lies there mirrored
};

/// Twice the area of a face in the texture, negative if mirrored; zero where it has none to speak of, or coordinates
/// are missing.
double spreadArea(const TextureSlopes& texture, Index f) {
  const Pair first = texture.uvs.row(3 * f).transpose().cast<double>();
  const Pair toSecond = texture.uvs.row(3 * f + 1).transpose().cast<double>() - first;
  const Pair toThird = texture.uvs.row(3 * f + 2).transpose().cast<double>() - first;
  const double area = toSecond.x() * toThird.y() - toThird.x() * toSecond.y();
  return std::abs(area) > kNoSpread * (toSecond.squaredNorm() + toThird.squaredNorm()) ? area : 0;
}

Spread spreadOf(const TriangleMesh& mesh, const TextureSlopes& texture, Index f) {
  const double area = spreadArea(texture, f);
  if (area == 0) return {};
  const auto corner = [&](int k) -> Vec3 { return mesh.positions.row(mesh.triangles(f, k)).transpose(); };
  const auto v = [&](int k) { return static_cast<double>(texture.uvs(3 * f + k, 1)); };
  const double sign = area < 0 ? -1 : 1;
  return {sign * ((v(2) - v(0)) * (corner(1) - corner(0)) - (v(1) - v(0)) * (corner(2) - corner(0))), sign};
}

/// The normal of a surface with this slope, in the frame that a face's texture makes about a normal; zero where it
/// makes none.
Vec3 raised(const Vec3& normal, const Spread& spread, const Pair& slope) {
  Vec3 x = spread.alongU - spread.alongU.dot(normal) * normal;
  const double length = x.norm();
  if (!(length > 1e-9 * spread.alongU.norm())) return Vec3::Zero();
  x /= length;
  const Vec3 y = spread.handedness * normal.cross(x);
  return (normal - slope.x() * x - slope.y() * y).normalized();
}

Pair slopeAt(const TextureSlopes& texture, Index corner) {
  return texture.slopes.row(corner).transpose().cast<double>();
}

}  // namespace

bool operator==(const TextureSlopes& a, const TextureSlopes& b) {
  // Missing coordinates are NaN, which equals nothing: such textures are taken for new ones.
  const auto same = [](const auto& x, const auto& y) { return x.rows() == y.rows() && x == y; };
  return same(a.slopes, b.slopes) && same(a.uvs, b.uvs);
}

Status validateTextureSlopes(const TextureSlopes& texture, Index faceCount) {
  if (texture.uvs.rows() != 3 * faceCount || texture.slopes.rows() != 3 * faceCount) {
    return Status::failure(Code::badParameter,
                           "the texture must have coordinates and a slope for each corner of the mesh’s " +
                               std::to_string(faceCount) + " faces");
  }
  if (!texture.slopes.allFinite()) return Status::failure(Code::badParameter, "a slope of the texture is not finite");
  for (Index f = 0; f < faceCount; ++f) {
    if (spreadArea(texture, f) != 0) return {};
  }
  return Status::failure(
      Code::unsuitableMesh,
      "the texture coordinates of all faces are single points or lines, so no image can lie on them; unwrap the "
      "mesh and export it again");
}

Points raisedVertexNormals(const TriangleMesh& mesh, const Points& normals, const TextureSlopes& texture,
                           double strength) {
  const Scalars areas = faceAreas(mesh.positions, mesh.triangles);
  Points sums = Points::Zero(normals.rows(), 3);
  std::vector<bool> isRaised(static_cast<std::size_t>(normals.rows()), false);
  for (Index f = 0; f < mesh.faceCount(); ++f) {
    const Spread spread = spreadOf(mesh, texture, f);
    if (spread.alongU.isZero(0)) continue;
    for (int k = 0; k < 3; ++k) {
      const Index v = mesh.triangles(f, k);
      const Pair slope = strength * slopeAt(texture, 3 * f + k);
      if (!slope.isZero(0)) isRaised[static_cast<std::size_t>(v)] = true;
      sums.row(v) += areas[f] * raised(normals.row(v).transpose(), spread, slope).transpose();
    }
  }
  for (Index v = 0; v < normals.rows(); ++v) {
    const bool isKnown = isRaised[static_cast<std::size_t>(v)] && !sums.row(v).isZero(0) && !normals.row(v).isZero(0);
    sums.row(v) = isKnown ? sums.row(v).stableNormalized().eval() : normals.row(v).eval();
  }
  return sums;
}

Points raisedFaceNormals(const TriangleMesh& mesh, const Points& normals, const TextureSlopes& texture,
                         double strength) {
  Points targets = normals;
  for (Index f = 0; f < mesh.faceCount(); ++f) {
    const Pair sum = slopeAt(texture, 3 * f) + slopeAt(texture, 3 * f + 1) + slopeAt(texture, 3 * f + 2);
    const Pair slope = strength / 3 * sum;
    if (slope.isZero(0)) continue;
    const Vec3 target = raised(normals.row(f).transpose(), spreadOf(mesh, texture, f), slope);
    if (!target.isZero(0)) targets.row(f) = target.transpose();
  }
  return targets;
}

}  // namespace whittle
