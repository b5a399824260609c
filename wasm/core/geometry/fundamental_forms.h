#pragma once

#include <array>
#include <vector>

#include "mesh/edges.h"

namespace whittle {

using Vec2 = Eigen::Vector2d;
using Mat2 = Eigen::Matrix2d;
using Mat32 = Eigen::Matrix<double, 3, 2>;

/// What lies across the sides of a face, side k being opposite to corner k. A border has nothing across; where three
/// faces or more share an edge, each has the next one around for its neighbour.
struct FaceHinge {
  Index face = -1;                     // −1 at a border
  int opposite = 0;                    // its corner that is not on the side
  std::array<int, 2> onSide = {0, 0};  // its corners in the vertices of corners k + 1 and k + 2
  double sign = 1;                     // −1 where the two faces look different ways
};
using FaceHinges = std::array<FaceHinge, 3>;

/// The hinges of each face, #F.
std::vector<FaceHinges> faceHinges(const Triangles& triangles, const MeshEdges& edges);

/// A face at rest in an orthonormal frame of its plane, in which both forms of what becomes of it are written.
struct FaceFrame {
  Mat32 axes;                     // the first along the side from corner 0 to corner 1
  Vec3 normal;                    // unit
  std::array<Vec2, 3> gradients;  // of the hat functions of its corners
  double area = 0;

  /// @param corners of a face that has an area
  static FaceFrame of(const std::array<Vec3, 3>& corners);
};

/// The unit normal of a face and how it turns when corners move: dn = −Σ slopes[a] (normal · dx_a). The slopes are the
/// gradients of the hat functions.
struct FaceTilt {
  Vec3 normal;
  std::array<Vec3, 3> slopes;
};

/// The tilt of each face; not finite where a face has no area.
void findTilts(const Points& positions, const Triangles& triangles, std::vector<FaceTilt>& tilts);

/// The normal halfway between two faces, n = m / |m| with m the sum of their unit normals. Where they all but fold onto
/// each other (|m| < 0.05) it is m / 0.05, whose derivative stays bounded.
struct MidEdgeNormal {
  Vec3 normal;
  double length;  // by which m is divided
  bool isUnit;

  explicit MidEdgeNormal(const Vec3& sum);
  /// dn for a dm; a symmetric map.
  Vec3 change(const Vec3& sumChange) const {
    const Vec3 scaled = sumChange / length;
    return isUnit ? Vec3(scaled - normal * normal.dot(scaled)) : scaled;
  }
};

/// How far a face rises across a side: w_k = (x_{k+1} + x_{k+2} − 2 x_k) · n_k, n_k the mid-edge normal; 0 at a border.
struct Rise {
  double height = 0;
  Vec3 normal = Vec3::Zero();  // n_k
  Vec3 turn = Vec3::Zero();    // gradient with respect to the sum of the two normals
};

/// The derivative of a rise: with respect to the face's own corners, and to the corner across.
struct RiseGradient {
  std::array<Vec3, 3> corners;
  Vec3 across;
};

/// Both fundamental forms of a face in the frame that it had at rest, 2×2 and symmetric.
struct FaceForms {
  Mat32 gradient;  // of the map from the frame into space
  Mat2 first;      // C = FᵀF: the identity at rest
  Mat2 second;     // b = −Σ w_k g_k g_kᵀ, from mid-edge normals
  std::array<Rise, 3> rises;
};

/// A mesh in the shape whose forms are asked for.
struct FormsInput {
  const Points& positions;
  const Triangles& triangles;
  const std::vector<FaceHinges>& hinges;
  const std::vector<FaceTilt>& tilts;  // of these positions

  Vec3 corner(Index face, int k) const { return positions.row(triangles(face, k)).transpose(); }
};

FaceForms formsOf(const FormsInput& mesh, const FaceFrame& rest, Index face);

/// d(C₁₁, C₁₂, C₂₂) / dx of a corner whose hat function has the gradient g.
Mat3 firstFormGradient(const FaceForms& forms, const Vec2& g);

/// The derivative of rise k of a face, which must have a face across.
RiseGradient riseGradient(const FormsInput& mesh, const FaceForms& forms, Index face, int k);

}  // namespace whittle
