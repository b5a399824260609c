#pragma once

#include <vector>

#include "mesh/triangle_mesh.h"
#include "methods/plastic/plastic_field.h"

namespace whittle {

/// A thin sheet of St. Venant–Kirchhoff material. Young's modulus is 1: nothing depends on it.
struct ShellMaterial {
  double thickness = 1;  // in the unit of the positions
  double poisson = 0.3;

  double onTrace() const { return poisson / (1 - poisson * poisson); }  // c₁
  double onSquare() const { return 1 / (2 * (1 + poisson)); }           // c₂
  /// Factors of the energies of stretching and bending, each by area.
  double stretching() const { return thickness / 4; }
  double bending() const { return thickness * thickness * thickness / 12; }
};

/// What a face is drawn to by its plastic degrees of freedom.
struct FaceGoal {
  Mat2 stretch;      // S
  Mat2 inverse;      // P = S⁻², the inverse of the first form that it is to have
  Mat2 second;       // b̄, the second form that it is to have: sym(B S)
  Mat2 turnedEdges;  // B = 2 Σ g_k τ_kᵀ
  double weight;     // area after the stretch
};

/// What a face has for energy, and its derivative with respect to its forms.
struct FaceStress {
  double energy;
  Mat2 membrane;  // σ = dW/dC
  Mat2 moment;    // μ = dW/db
};

/// A thin shell in a shape: each face drawn to what its plastic degrees of freedom make of its rest shape, with the
/// energy of Eq. 13, its gradient and what Hessian and sensitivities are made of.
class Shell {
 public:
  /// Takes a mesh at rest, without faces of no area, with nothing plastic about it and in its rest shape.
  void setRest(TriangleMesh rest, const ShellMaterial& material);
  /// Other positions at rest of the same mesh; what is plastic is forgotten.
  void setRestPositions(const Points& positions);
  void setPlastic(const PlasticField& field);
  /// Takes the shape for which all that follows is asked. Allocates nothing.
  void setShape(const Points& positions);

  Index vertexCount() const { return rest_.vertexCount(); }
  Index faceCount() const { return rest_.faceCount(); }
  const Triangles& triangles() const { return rest_.triangles; }
  const std::vector<FaceHinges>& hinges() const { return hinges_; }
  const std::vector<FaceFrame>& frames() const { return frames_; }
  const PlasticField& plastic() const { return plastic_; }
  const FaceGoal& goal(Index face) const { return goals_[face]; }
  const FaceForms& forms(Index face) const { return forms_[face]; }
  const ShellMaterial& material() const { return material_; }
  FormsInput input() const { return {positions_, rest_.triangles, hinges_, tilts_}; }

  FaceStress stress(Index face) const;
  double energy() const;
  /// The energy, and its gradient with respect to the positions (#V×3). Allocates nothing.
  double energy(Points& gradient) const;
  /// Adds what derivatives of an energy with respect to a face's forms are as forces on its vertices and those across its
  /// sides (#V×3).
  void addForces(Index face, const Mat2& membrane, const Mat2& moment, Points& forces) const;
  /// The smallest eigenvalue over all faces of S⁻¹ C S⁻¹, the square of how far the shell is pressed together beyond what
  /// is plastic: 1 where nothing is. Its energy has no resistance left below 1/3.
  double smallestSquaredStretch() const;

  /// The sum of the normals at hinge k of a face after their plastic rotations, in the face's own turned frame: of
  /// Eq. 15, with the neighbour's turned normal in space.
  struct TurnedHinge {
    Vec3 sum;
    Vec3 across;  // R_u d_u
  };
  TurnedHinge turnedHinge(Index face, int k) const;

 private:
  void setGoals();

  TriangleMesh rest_;
  ShellMaterial material_;
  std::vector<FaceHinges> hinges_;
  std::vector<FaceFrame> frames_;
  PlasticField plastic_;
  std::vector<Mat3> turns_;  // R
  std::vector<FaceGoal> goals_;
  Points positions_;
  std::vector<FaceTilt> tilts_;
  std::vector<FaceForms> forms_;
};

}  // namespace whittle
