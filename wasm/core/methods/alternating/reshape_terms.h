#pragma once

#include "methods/alternating/reshape_energy.h"
#include "methods/alternating/reshape_parameters.h"
#include "methods/alternating/structure.h"

namespace whittle {

/// How far a run goes with the cures that keep the size of round parts. Where they leave no way without folding a face,
/// the next rung goes less far.
enum class Rung { full, less, none };
constexpr int kRungs = 3;

/// What the energy of a variant is made of.
struct ReshapeTerms {
  EnergyWeights weights;
  enum class Spheres { none, found, everywhere } spheres = Spheres::found;  // where Γ is
  double meanNormalsBelow = 0;                                              // radians, see `setEdgeNormals`
  double leastSimilarity = 1;                                               // in planes, see `fadeSimilarity`
  bool keepsRadii = false;                                                  // whether `keptDirections` are set
  double weakHandles = 1e5;  // of handles while errors next to them are spread

  static ReshapeTerms of(Variant variant, Reading reading, Rung rung);
};

/// Sets what the terms read of a surface: normals, similarity, Γ, and the directions that keep their length.
/// @param keptPatches of the structure's patches, those that keep their radius
void setTerms(const ReshapeTerms& terms, const Structure& structure, const std::vector<bool>& keptPatches,
              RestSurface& surface);

}  // namespace whittle
