#pragma once

#include <vector>

#include "methods/alternating/point_rows.h"
#include "methods/alternating/rest_surface.h"

namespace whittle {

/// τ of each face: how it maps directions of the rest shape, a full 3×3 matrix in world axes.
using Transformations = std::vector<Mat3>;

/// The weights of the terms; each multiplies a squared residual.
struct EnergyWeights {
  double normal = 10;         // w_normal
  double similarity = 1;      // of the similarity term as a whole; 0 switches it off
  double scale = 1e-4;        // w_scale
  double regularizer = 1e-4;  // w_reg, ‖τ − I‖²
  double keptRadius = 1;      // ‖(τ − I) c‖² on round parts that keep their radius
};

/// Where the vertices are to go and what the vertex solve takes for given: all per half edge, 3#F.
struct EdgeGoals {
  Points vectors;         // ē, 3#F×3: what edges are measured against
  Scalars lengths;        // l̄, of those
  Points normals;         // 3#F×3, unit
  Scalars targetLengths;  // l = ‖τ ē‖, mean over the faces of the edge
  Scalars stress;         // ω, ≥ 1: long edges count more
};

/// The sphericity term at corner i of a face, ‖u − R w‖² for the face's edges from that corner, u and w as shares of their
/// rest lengths: the factors of the face's three vertices, by corner.
void sphericityFactors(const RestSurface& surface, Index face, int corner, Mat3 factors[3]);

/// R of a corner: about the face's normal from the direction of the half edge that begins there to that of the one that
/// ends there, turned back.
Mat3 cornerRotation(const RestSurface& surface, Index face, int corner);

/// The energy of positions: all terms of the vertex solve with present lengths, but for its rows.
double vertexEnergy(const RestSurface& surface, const EnergyWeights& weights, const EdgeGoals& goals,
                    const Transformations& transformations, const Points& positions);
/// Σ stiffness · ‖residual‖² of rows.
double rowEnergy(const std::vector<PointRow>& rows, const Points& positions);

/// ω of edges of given lengths, max(1, (l / L_avg)²).
inline double stressOf(double length, double averageLength) {
  const double share = length / averageLength;
  return share > 1 ? share * share : 1;
}

/// The goals of a first solve: edges, lengths and normals of the rest shape.
EdgeGoals restGoals(const RestSurface& surface);

}  // namespace whittle
