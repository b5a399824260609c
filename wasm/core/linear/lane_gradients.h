#pragma once

#include <algorithm>

#include "simd/lanes.h"

namespace whittle {

/// Conjugate gradients in single precision over rows of lanes, for callers that solve for a correction of what they
/// have. Sums are in double precision: a hundred thousand rows would drown in single.
class LaneGradients {
 public:
  void shape(std::size_t rows) {
    for (LaneRows* scratch : {&preconditioned_, &direction_, &image_}) scratch->assign(rows, {});
  }

  /// Begins to make of a residual the correction that takes it away. Nothing here allocates.
  /// @param residual overwritten as iterations go
  /// @param precondition z = M⁻¹ r: precondition(r, z); returns rᵀ z
  /// @returns rᵀ M⁻¹ r of the start
  template <typename Precondition>
  double begin(const LaneRows& residual, LaneRows& correction, Precondition precondition) {
    std::fill(correction.begin(), correction.end(), LaneRow{});
    squared_ = precondition(residual, preconditioned_);
    direction_ = preconditioned_;
    return squared_;
  }

  /// Does an iteration; returns false where rounding leaves nothing to be gained.
  /// @param apply y = A x: apply(x, y); returns xᵀ y
  template <typename Apply, typename Precondition>
  bool iterate(LaneRows& residual, LaneRows& correction, Apply apply, Precondition precondition) {
    const double curvature = apply(direction_, image_);
    if (!(squared_ > 0 && curvature > 0)) return false;
    const Lanes step = splat(static_cast<float>(squared_ / curvature));
    for (std::size_t i = 0; i < direction_.size(); ++i) {
      store(&correction[i], load(&correction[i]) + step * load(&direction_[i]));
      store(&residual[i], load(&residual[i]) - step * load(&image_[i]));
    }
    const double next = precondition(residual, preconditioned_);
    const Lanes share = splat(static_cast<float>(next / squared_));
    for (std::size_t i = 0; i < direction_.size(); ++i)
      store(&direction_[i], load(&preconditioned_[i]) + share * load(&direction_[i]));
    squared_ = next;
    return true;
  }

  /// rᵀ M⁻¹ r of the present residual.
  double squared() const { return squared_; }

  static double dot(const LaneRows& a, const LaneRows& b) {
    DoubleLanes sum = {0, 0, 0, 0};
    for (std::size_t i = 0; i < a.size(); ++i) sum += toDouble(load(&a[i]) * load(&b[i]));
    return sumOf(sum);
  }

 private:
  LaneRows preconditioned_, direction_, image_;
  double squared_ = 0;
};

}  // namespace whittle
