#pragma once

#include <string>
#include <vector>

#include "methods/alternating/fold_check.h"
#include "methods/alternating/structure.h"

namespace whittle {

/// A handle that is missed by more, as a share of the diagonal, is told of, and asks for a second run.
constexpr double kMissed = 0.005;

/// A result and what was asked for.
struct ReshapeResult {
  const RestSurface& rest;
  const Structure& structure;
  const std::vector<bool>& keptPatches;
  const std::vector<PointRow>& handles;  // aimed
  const Points& positions;               // #V×3
  FoldReport folds;
  double handleError;  // the largest, as a share of the diagonal
  bool keepsSizes;     // whether round parts and walls were to stay as they are
};

/// What a person should know of a result, a sentence each.
std::vector<std::string> resultRemarks(const ReshapeResult& result);

}  // namespace whittle
