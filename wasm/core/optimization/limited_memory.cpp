#include "optimization/limited_memory.h"

#include <algorithm>

namespace whittle {

namespace {

/// A step along which the gradient changes less than this share of the lengths says nothing but rounding.
constexpr double kCurvature = 1e-12;

}  // namespace

void LimitedMemory::remember(const Scalars& step, const Scalars& gradientChange) {
  const double curvature = step.dot(gradientChange);
  if (!(curvature > kCurvature * step.norm() * gradientChange.norm())) return;
  pairs_.resize(most_);
  Pair& pair = pairs_[next_];
  pair.step = step;
  pair.change = gradientChange;
  pair.curvature = curvature;
  next_ = (next_ + 1) % most_;
  count_ = std::min(count_ + 1, most_);
}

void LimitedMemory::direction(const Scalars& gradient, const Inverse& inverse, Scalars& direction) {
  direction = -gradient;
  for (int age = 0; age < count_; ++age) {
    Pair& pair = recent(age);
    pair.share = pair.step.dot(direction) / pair.curvature;
    direction -= pair.share * pair.change;
  }
  inverse(direction);
  for (int age = count_ - 1; age >= 0; --age) {
    const Pair& pair = recent(age);
    direction += (pair.share - pair.change.dot(direction) / pair.curvature) * pair.step;
  }
}

}  // namespace whittle
