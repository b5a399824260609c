#include "support/style_runs.h"

#include <doctest/doctest.h>

#include <cmath>

#include "geometry/surface.h"

namespace whittle::testing {

GaussMapData cubeStyle() {
  GaussMapData data;
  data.normals.resize(6, 3);
  data.normals << Mat3::Identity(), -Mat3::Identity();
  return data;
}

GaussMapData octahedronStyle() {
  GaussMapData data;
  data.normals.resize(8, 3);
  for (int i = 0; i < 8; ++i) data.normals.row(i) << (i & 1 ? 1 : -1), (i & 2 ? 1 : -1), (i & 4 ? 1 : -1);
  return data;
}

void prepareAnalogy(Session& session, const Analogy& analogy) {
  REQUIRE(session.select("analogy").ok());
  REQUIRE(session.set("style", encoded(analogy.style)).ok());
  REQUIRE(session.set("lambda", encoded(analogy.lambda)).ok());
  REQUIRE(session.set("regularizer", encoded(analogy.regularizer)).ok());
  REQUIRE(session.set("dynamicTargets", encoded(analogy.isDynamic)).ok());
  REQUIRE(session.set("lambdaPerVertex", encoded(analogy.lambdaPerVertex)).ok());
  REQUIRE(session.set("acceleration", encoded(analogy.acceleration)).ok());
  REQUIRE(session.set("tolerance", encoded(analogy.tolerance)).ok());
  REQUIRE(session.set("maxIterations", encoded(analogy.maxIterations)).ok());
  REQUIRE(session.set("handles", encoded(analogy.handles)).ok());
  REQUIRE(session.prepare().ok());
}

Run run(const TriangleMesh& mesh, const Analogy& analogy) {
  Session session;
  REQUIRE(session.load(mesh).ok());
  prepareAnalogy(session, analogy);
  return finish(session);
}

double angleToStyle(const Points& positions, const Triangles& triangles, const GaussMap& style) {
  const Points normals = faceNormals(positions, triangles);
  const Scalars areas = faceAreas(positions, triangles);
  double sum = 0;
  for (Index f = 0; f < triangles.rows(); ++f) {
    const Vec3 n = normals.row(f).transpose(), t = style(n);
    sum += areas[f] * std::atan2(n.cross(t).norm(), n.dot(t));
  }
  return sum / areas.sum() * 180 / EIGEN_PI;
}

}  // namespace whittle::testing
