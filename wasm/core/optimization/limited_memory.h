#pragma once

#include <functional>
#include <vector>

#include "base/types.h"

namespace whittle {

/// What the last steps of a descent say of the curvature, over a first guess of the inverse Hessian (L-BFGS, two-loop
/// recursion).
class LimitedMemory {
 public:
  /// Overwrites a vector with the first guess of the inverse Hessian times it; the guess is positive definite.
  using Inverse = std::function<void(Scalars&)>;

  /// @param pairs of steps that are remembered
  explicit LimitedMemory(int pairs = 10) : most_(pairs) {}

  void forget() { count_ = 0; }

  /// Remembers a step and by how much it changed the gradient; one along which nothing curves upwards is left out.
  void remember(const Scalars& step, const Scalars& gradientChange);

  /// The direction of descent at a gradient. Allocates only for vectors that are longer than ever before.
  void direction(const Scalars& gradient, const Inverse& inverse, Scalars& direction);

 private:
  struct Pair {
    Scalars step, change;
    double curvature = 0;  // their product
    double share = 0;      // scratch
  };

  Pair& recent(int age) { return pairs_[(next_ - 1 - age + 2 * most_) % most_]; }

  int most_;
  int count_ = 0, next_ = 0;
  std::vector<Pair> pairs_;
};

}  // namespace whittle
