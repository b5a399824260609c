#include "optimization/constrained_descent.h"

#include <cmath>

#include "optimization/pseudo_inverse.h"

namespace whittle {

namespace {

/// Combinations of free unknowns whose effect is a smaller share of the largest are none.
constexpr double kNoEffect = 1e-10;

}  // namespace

void ConstrainedDescent::begin(const Scalars& y, const Eigen::MatrixXd& G, const LowRankInverse& inverse,
                               const Limits& limits) {
  G_ = &G;
  inverse_ = &inverse;
  limits_ = limits;
  inverseG_ = inverse.apply(G);
  schur_ = pseudoInverse(G.transpose() * inverseG_, kNoEffect);
  multipliers_.setZero(y.size());
  residual_ = y;
  iterations_ = 0;
  direction_ = precondition(residual_);
  energy_ = first_ = residual_.dot(direction_);
  isDone_ = !(energy_ > 0) || limits.iterations == 0;
}

Scalars ConstrainedDescent::precondition(const Scalars& residual) const {
  const Scalars z = inverse_->apply(residual);
  return z - inverseG_ * (schur_ * (G_->transpose() * z));
}

void ConstrainedDescent::advance(const Scalars& image) {
  const double curvature = direction_.dot(image);
  ++iterations_;
  if (!(curvature > 0)) {
    isDone_ = true;
    return;
  }
  const double length = energy_ / curvature;
  multipliers_ += length * direction_;
  residual_ -= length * image;
  const Scalars z = precondition(residual_);
  const double energy = residual_.dot(z);
  isDone_ = !(energy > limits_.residual * limits_.residual * first_) || iterations_ >= limits_.iterations;
  direction_ = z + energy / energy_ * direction_;
  energy_ = energy;
}

Scalars ConstrainedDescent::free() const { return schur_ * (inverseG_.transpose() * residual_); }

}  // namespace whittle
