#include "methods/alternating/result_remarks.h"

#include <cstdio>

#include "methods/alternating/kept_sizes.h"
#include "methods/alternating/kept_thickness.h"

namespace whittle {

namespace {

/// The share of what is thin that must have changed its thickness to be told of.
constexpr double kLeastChanged = 0.05;

template <typename... Values>
std::string sentence(const char* format, Values... values) {
  char text[200];
  std::snprintf(text, sizeof text, format, values...);
  return text;
}

}  // namespace

std::vector<std::string> resultRemarks(const ReshapeResult& result) {
  std::vector<std::string> remarks;
  if (result.folds.flipped > 0) {
    remarks.push_back("Of the faces " + std::to_string(result.folds.flipped) +
                      " fold over; a smaller move, or more handles, may help.");
  }
  if (result.keepsSizes) {
    const SizeReport sizes =
        findChangedSizes(result.rest, result.structure.patches, result.keptPatches, result.positions);
    if (sizes.changed > 0) {
      remarks.push_back(sentence(
          "Of the holes, round parts and bevels %d %s by this gesture; the farthest is %.2f times what it was.",
          static_cast<int>(sizes.changed), sizes.changed == 1 ? "changes its size" : "change their size", sizes.most));
    }
    const ThicknessReport walls =
        findChangedThickness(result.rest, result.structure.walls.probes, result.handles, result.positions);
    if (walls.changedArea > kLeastChanged) {
      remarks.push_back(sentence("Walls and thin parts become up to %.2f times as thick by this gesture.", walls.most));
    }
  }
  if (result.handleError > kMissed) {
    remarks.push_back(sentence(
        "A handle is missed by %.1f %% of the diagonal: what the handles ask for does not go together with the shape.",
        100 * result.handleError));
  }
  return remarks;
}

}  // namespace whittle
