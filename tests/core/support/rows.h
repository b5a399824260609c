#pragma once

#include "simd/lane_algebra.h"

namespace whittle::testing {

/// Points rounded to rows in single precision, filled up to whole batches, and back.
inline LaneRows toRows(const Points& points) {
  LaneRows rows(4 * batchCount(static_cast<Index>(points.rows())));
  for (Index i = 0; i < points.rows(); ++i) setRow(rows[i], points.row(i).transpose());
  return rows;
}

inline Points toPoints(const LaneRows& rows, Index count) {
  Points points(count, 3);
  for (Index i = 0; i < count; ++i) points.row(i) << rows[i].x, rows[i].y, rows[i].z;
  return points;
}

}  // namespace whittle::testing
