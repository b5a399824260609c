#pragma once

#include <vector>

#include "base/types.h"

namespace whittle {

/// Anderson's acceleration of an iteration x → g(x) towards its fixed point: the next x is the combination of the last
/// results whose steps g(x) − x, combined alike, are least (type II). Allocates only when it begins.
class Anderson {
 public:
  static constexpr int kDepth = 5;

  /// @param vertexCount rows of the points to come
  void begin(Index vertexCount);
  /// Forgets what it has seen: the next x is the next result.
  void forget() { seen_ = 0; }
  /// Whether the last x was any other point than a result.
  bool isMixing() const { return seen_ > 1; }

  /// Replaces x, whose result is given, by the next one.
  void next(const Points& result, Points& x);

 private:
  int seen_ = 0;
  Points stepBefore_, resultBefore_;
  std::vector<Points> steps_, results_;  // changes of both, the last kDepth, in a ring
};

}  // namespace whittle
