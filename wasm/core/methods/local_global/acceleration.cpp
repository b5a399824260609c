#include "methods/local_global/acceleration.h"

#include <cmath>

namespace whittle {

namespace {

constexpr double kRelaxation = 1.8;

}  // namespace

void Acceleration::begin(Kind kind) {
  kind_ = kind;
  fresh_ = true;
  momentum_ = 1;
}

bool Acceleration::extrapolate(const Displacements& iterate, const Displacements& before) {
  bool moved = false;
  if (fresh_ || kind_ == Kind::none) {
    start_ = iterate;
  } else if (kind_ == Kind::relaxed) {
    start_.combine(start_, kRelaxation, iterate, start_);
    moved = true;
  } else {
    const double next = (1 + std::sqrt(1 + 4 * momentum_ * momentum_)) / 2;
    const double beta = (momentum_ - 1) / next;
    momentum_ = next;
    start_.combine(iterate, beta, iterate, before);
    moved = beta > 0;
  }
  fresh_ = false;
  return moved;
}

void Acceleration::reject(const Displacements& iterate) {
  start_ = iterate;
  momentum_ = 1;
}

}  // namespace whittle
