#pragma once

#include "mesh/triangle_mesh.h"

namespace whittle::testing {

/// Volume inside a closed surface.
double volumeInside(const Points& positions, const Triangles& triangles);

/// How many edges between faces that lay in one plane have come to bend by more than 25°.
int bentPairCount(const TriangleMesh& before, const Points& positions);

/// How many edges are folded over: their two faces lie back on each other to within 30°.
int foldCount(const Points& positions, const Triangles& triangles);

/// Share of the area whose normals are within `degrees` of some unit directions (#N×3).
double shareWithin(double degrees, const Points& directions, const Points& positions, const Triangles& triangles);

/// Gaussian curvature gathered at each vertex, 2π − Σ angles, #V; zero at the rim.
Scalars angleDefects(const Points& positions, const Triangles& triangles);

/// The whole cotangent Laplacian as a dense matrix, #V×#V.
Eigen::MatrixXd denseLaplacian(const TriangleMesh& mesh);

}  // namespace whittle::testing
