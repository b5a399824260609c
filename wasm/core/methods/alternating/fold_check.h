#pragma once

#include "methods/alternating/rest_surface.h"
#include "remeshing/transfer.h"

namespace whittle {

/// What a result did to the faces.
struct FoldReport {
  Index flipped = 0;       // faces that look the other way
  Index steep = 0;         // faces that have turned by more than 60°
  double steepArea = 0;    // theirs at rest, as a share of all
  double poorQuality = 1;  // triangle quality over that at rest, which one face in a hundred does not reach

  /// Faces that fold count as none where they are too small to be seen: no size of a hole is worth these.
  bool isClean() const { return steepArea < kUnseenArea && poorQuality >= 0.1; }
  bool isBetterThan(const FoldReport& other) const {
    if (flipped != other.flipped) return flipped < other.flipped;
    return steep != other.steep ? steep < other.steep : poorQuality > other.poorQuality;
  }

  static constexpr double kUnseenArea = 1e-6;
};

FoldReport findFolds(const RestSurface& surface, const Points& positions);

/// What a working surface became, and the way back from it.
struct CarriedBack {
  const RestSurface& surface;
  const Points& positions;  // #V of the surface ×3
  const Transfer& transfer;
};

/// How many faces of the input turn over in their own plane as they follow the surface, where the surface itself does
/// not: thin faces whose corners are carried past each other. What is seen of the shape does not change with them.
/// @param positions of the input's vertices, #V×3, as they were carried back
Index turnedInPlane(const TriangleMesh& input, const Points& positions, const CarriedBack& from);

}  // namespace whittle
