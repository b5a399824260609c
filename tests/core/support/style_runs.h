#pragma once

#include <string>

#include "support/runs.h"
#include "targets/gauss_map.h"

namespace whittle::testing {

/// The closest of the six directions of a cube.
GaussMapData cubeStyle();
/// The closest of the eight of an octahedron.
GaussMapData octahedronStyle();

/// One run of `analogy`.
struct Analogy {
  GaussMapData style = cubeStyle();
  double lambda = 1;
  std::string regularizer = "arap";
  bool isDynamic = false;
  double tolerance = 3e-3;
  int maxIterations = 300;
  std::string acceleration = "nesterov";
  Handles handles = {};
  Scalars lambdaPerVertex = {};
};

/// Gives a session that holds a mesh the method and its parameters, and prepares it.
void prepareAnalogy(Session& session, const Analogy& analogy);

Run run(const TriangleMesh& mesh, const Analogy& analogy);

/// Mean angle between face normals and what the style has for them, area-weighted, in degrees.
double angleToStyle(const Points& positions, const Triangles& triangles, const GaussMap& style);

}  // namespace whittle::testing
