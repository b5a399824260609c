#pragma once

#include <vector>

#include "base/lanes.h"
#include "base/types.h"

namespace whittle::testing {

/// Points rounded to rows in single precision, and back.
inline std::vector<LaneRow> toRows(const Points& points) {
  std::vector<LaneRow> rows;
  for (Index i = 0; i < points.rows(); ++i) {
    rows.push_back({static_cast<float>(points(i, 0)), static_cast<float>(points(i, 1)), static_cast<float>(points(i, 2)), 0});
  }
  return rows;
}

inline Points toPoints(const std::vector<LaneRow>& rows) {
  Points points(rows.size(), 3);
  for (std::size_t i = 0; i < rows.size(); ++i) points.row(i) << rows[i].x, rows[i].y, rows[i].z;
  return points;
}

}  // namespace whittle::testing
