#include "geometry/surface.h"

#include <algorithm>

namespace whittle {

namespace {

/// A face whose doubled area is below this share of its longest edge squared has no normal but rounding: files hold
/// positions in single precision.
constexpr double kNoArea = 1e-6;

Vec3 doubledAreaVector(const Points& positions, const Triangles& triangles, Index f) {
  const Vec3 a = positions.row(triangles(f, 0)).transpose();
  const Vec3 b = positions.row(triangles(f, 1)).transpose();
  const Vec3 c = positions.row(triangles(f, 2)).transpose();
  return (b - a).cross(c - a);
}

/// Where each corner of a face adds what it has: at its vertex, or at its fan.
const Triangles& placesOf(const Triangles& triangles, const SmoothFans& fans) {
  return fans.areVertices() ? triangles : fans.ofCorner;
}

Scalars barycentricAreasAt(const Triangles& places, Index count, const Points& positions, const Triangles& triangles) {
  Scalars areas = Scalars::Zero(count);
  for (Index f = 0; f < triangles.rows(); ++f) {
    const double share = doubledAreaVector(positions, triangles, f).norm() / 6;
    for (int k = 0; k < 3; ++k) areas[places(f, k)] += share;
  }
  return areas;
}

Scalars mixedVoronoiAreasAt(const Triangles& places, Index count, const Points& positions, const Triangles& triangles) {
  Scalars areas = Scalars::Zero(count);
  for (Index f = 0; f < triangles.rows(); ++f) {
    const double doubled = doubledAreaVector(positions, triangles, f).norm();
    if (doubled == 0) continue;
    Vec3 squares, dots;  // of the edge opposite to each corner, and of the two edges at it
    for (int k = 0; k < 3; ++k) {
      const auto at = [&](int corner) { return positions.row(triangles(f, (k + corner) % 3)); };
      squares[k] = (at(2) - at(1)).squaredNorm();
      dots[k] = (at(1) - at(0)).dot(at(2) - at(0));
    }
    for (int k = 0; k < 3; ++k) {
      double share;
      if (dots.minCoeff() < 0) {
        share = dots[k] < 0 ? doubled / 4 : doubled / 8;
      } else {
        // ⅛ Σ cot(opposite angle) |edge|² over the two edges at the corner
        share = (dots[(k + 1) % 3] * squares[(k + 1) % 3] + dots[(k + 2) % 3] * squares[(k + 2) % 3]) / (8 * doubled);
      }
      areas[places(f, k)] += share;
    }
  }
  return areas;
}

void cornerNormals(const Triangles& places, const Points& positions, const Triangles& triangles, Points& normals,
                   Scalars& areas) {
  normals.setZero();
  areas.setZero();
  for (Index f = 0; f < triangles.rows(); ++f) {
    const Vec3 vector = doubledAreaVector(positions, triangles, f);
    const double area = vector.norm();
    for (int k = 0; k < 3; ++k) {
      normals.row(places(f, k)) += vector.transpose();
      areas[places(f, k)] += area;
    }
  }
  for (Index v = 0; v < normals.rows(); ++v) {
    // A sum far below its terms is rounding: two sheets back to back have no normal, not a random one.
    const double length = normals.row(v).norm();
    if (length > 1e-10 * areas[v]) {
      normals.row(v) /= length;
    } else {
      normals.row(v).setZero();
    }
  }
}

}  // namespace

Scalars faceAreas(const Points& positions, const Triangles& triangles) {
  Scalars areas(triangles.rows());
  for (Index f = 0; f < triangles.rows(); ++f) areas[f] = 0.5 * doubledAreaVector(positions, triangles, f).norm();
  return areas;
}

Scalars barycentricAreas(const Points& positions, const Triangles& triangles) {
  return barycentricAreasAt(triangles, static_cast<Index>(positions.rows()), positions, triangles);
}

Scalars barycentricAreas(const Points& positions, const Triangles& triangles, const SmoothFans& fans) {
  return barycentricAreasAt(placesOf(triangles, fans), fans.count(), positions, triangles);
}

Scalars mixedVoronoiAreas(const Points& positions, const Triangles& triangles) {
  return mixedVoronoiAreasAt(triangles, static_cast<Index>(positions.rows()), positions, triangles);
}

Scalars mixedVoronoiAreas(const Points& positions, const Triangles& triangles, const SmoothFans& fans) {
  return mixedVoronoiAreasAt(placesOf(triangles, fans), fans.count(), positions, triangles);
}

Points vertexNormals(const Points& positions, const Triangles& triangles) {
  Points normals(positions.rows(), 3);
  Scalars areas(positions.rows());
  vertexNormals(positions, triangles, normals, areas);
  return normals;
}

void vertexNormals(const Points& positions, const Triangles& triangles, Points& normals, Scalars& areas) {
  cornerNormals(triangles, positions, triangles, normals, areas);
}

Points fanNormals(const Points& positions, const Triangles& triangles, const SmoothFans& fans) {
  Points normals(fans.count(), 3);
  Scalars areas(fans.count());
  fanNormals(positions, triangles, fans, normals, areas);
  return normals;
}

void fanNormals(const Points& positions, const Triangles& triangles, const SmoothFans& fans, Points& normals,
                Scalars& areas) {
  cornerNormals(placesOf(triangles, fans), positions, triangles, normals, areas);
}

Points faceNormals(const Points& positions, const Triangles& triangles) {
  Points normals(triangles.rows(), 3);
  faceNormals(positions, triangles, normals);
  return normals;
}

void faceNormals(const Points& positions, const Triangles& triangles, Points& normals) {
  for (Index f = 0; f < triangles.rows(); ++f) {
    normals.row(f) = doubledAreaVector(positions, triangles, f).stableNormalized().transpose();
  }
}

Points sureNormals(const Points& positions, const Triangles& triangles) {
  Points normals(triangles.rows(), 3);
  for (Index f = 0; f < triangles.rows(); ++f) {
    const Eigen::RowVector3d a = positions.row(triangles(f, 0)), b = positions.row(triangles(f, 1)),
                             c = positions.row(triangles(f, 2));
    const Eigen::RowVector3d vector = (b - a).cross(c - a);
    const double longest = std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
    const double length = vector.norm();
    if (length > kNoArea * longest) {
      normals.row(f) = vector / length;
    } else {
      normals.row(f).setZero();
    }
  }
  return normals;
}

}  // namespace whittle
