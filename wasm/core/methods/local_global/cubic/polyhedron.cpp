#include "methods/local_global/cubic/polyhedron.h"

#include <cmath>

namespace whittle {

namespace {

void add(Polyhedron& polyhedron, const Vec3& direction, double length) {
  polyhedron.rows[polyhedron.rowCount] = direction.normalized();
  polyhedron.lengths[polyhedron.rowCount] = length;
  ++polyhedron.rowCount;
}

}  // namespace

Choices<Polyhedron::Name> Polyhedron::names() {
  return {{"cube", Name::cube},
          {"hexagonal-prism", Name::hexagonalPrism},
          {"rhombic-dodecahedron", Name::rhombicDodecahedron},
          {"truncated-octahedron", Name::truncatedOctahedron}};
}

Polyhedron Polyhedron::named(Name name) {
  Polyhedron result;
  switch (name) {
    case Name::cube: return box(Vec3::Ones());
    case Name::hexagonalPrism:  // upright: y is up
      for (const Vec3& side : {Vec3(2, 0, 0), Vec3(1, 0, std::sqrt(3.0)), Vec3(-1, 0, std::sqrt(3.0))})
        add(result, side, 2.0 / 3);
      add(result, Vec3::UnitY(), 1);
      break;
    case Name::rhombicDodecahedron:
      for (const double y : {1, -1}) {
        for (const double z : {1, -1}) add(result, {1, y, z}, 0.75);
      }
      break;
    case Name::truncatedOctahedron:
      for (int axis = 0; axis < 3; ++axis) {
        for (const double sign : {1, -1}) add(result, Vec3::Unit(axis) + sign * Vec3::Unit((axis + 1) % 3), 0.5);
      }
      break;
  }
  return result;
}

Polyhedron Polyhedron::box(const Vec3& lengths) {
  Polyhedron result;
  for (int axis = 0; axis < 3; ++axis) {
    if (lengths[axis] > 0) add(result, Vec3::Unit(axis), lengths[axis]);
  }
  return result;
}

Polyhedron Polyhedron::ofRows(const Points& rows) {
  Polyhedron result;
  for (Index j = 0; j < rows.rows(); ++j) {
    const Vec3 row = rows.row(j).transpose();
    add(result, row, row.norm());
  }
  return result;
}

double Polyhedron::support(const Vec3& s) const {
  double sum = 0;
  for (Index j = 0; j < rowCount; ++j) sum += lengths[j] * std::abs(rows[j].dot(s));
  return sum;
}

double Polyhedron::regularizer(FanNormals normals, const Mat3& R) const {
  double sum = 0;
  for (const FanNormal& normal : normals) {
    if (normal.weight > 0) sum += normal.weight * support(R * normal.n);
  }
  return sum;
}

PolyhedralVertex::PolyhedralVertex(const CubicVertex& cubic)
    : M(cubic.M), n(cubic.n), weight(cubic.weights.maxCoeff()) {
  if (weight > 0) polyhedron = Polyhedron::box(cubic.weights / weight);
}

Mat3 PolyhedralVertex::pulledAt(const Vec3& s) const {
  Vec3 y = Vec3::Zero();
  for (Index j = 0; j < polyhedron.rowCount; ++j) {
    y += std::copysign(polyhedron.lengths[j], polyhedron.rows[j].dot(s)) * polyhedron.rows[j];
  }
  return M - weight * n * y.transpose();
}

}  // namespace whittle
