#pragma once

#include "methods/alternating/rest_surface.h"

namespace whittle {

/// What a result did to the faces.
struct FoldReport {
  Index flipped = 0;       // faces that look the other way
  Index steep = 0;         // faces that have turned by more than 60°
  double poorQuality = 1;  // triangle quality over that at rest, which one face in a hundred does not reach

  bool isClean() const { return flipped == 0 && steep == 0 && poorQuality >= 0.1; }
  bool isBetterThan(const FoldReport& other) const {
    if (flipped != other.flipped) return flipped < other.flipped;
    return steep != other.steep ? steep < other.steep : poorQuality > other.poorQuality;
  }
};

FoldReport findFolds(const RestSurface& surface, const Points& positions);

}  // namespace whittle
