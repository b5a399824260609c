#include "methods/alternating/anderson.h"

#include <doctest/doctest.h>

using namespace whittle;

namespace {

constexpr Index kCount = 40;

/// A contraction with slow directions: every coordinate goes to its own end by its own share, `kRates` of them.
constexpr double kRates[] = {0.99, 0.95, 0.9, 0.5};

Points contracted(const Points& x) {
  Points result = x;
  for (Index v = 0; v < kCount; ++v) {
    const double rate = kRates[v % 4];
    result.row(v) = rate * x.row(v) + (1 - rate) * Vec3(v, 1, -2.0 * v).transpose();
  }
  return result;
}

double stepOf(const Points& x) { return (contracted(x) - x).cwiseAbs().maxCoeff(); }

}  // namespace

TEST_CASE("a linear iteration of few rates ends at its fixed point once all of them were seen") {
  Anderson acceleration;
  acceleration.begin(kCount);
  Points x = Points::Zero(kCount, 3), plain = x;
  const double first = stepOf(x);
  for (int i = 0; i < 8; ++i) {
    acceleration.next(contracted(x), x);
    plain = contracted(plain);
  }
  CHECK(stepOf(x) < 1e-5 * first);
  CHECK(stepOf(plain) > 0.05 * first);
  // What is forgotten makes no difference to what comes.
  acceleration.forget();
  CHECK(!acceleration.isMixing());
  Points fresh = Points::Zero(kCount, 3);
  const Points result = contracted(fresh);
  acceleration.next(result, fresh);
  CHECK(fresh == result);
}

TEST_CASE("nothing that moves is nothing to divide by") {
  Anderson acceleration;
  acceleration.begin(kCount);
  const Points still = Points::Constant(kCount, 3, 0.5);
  Points x = still;
  for (int i = 0; i < 8; ++i) acceleration.next(still, x);
  CHECK(x == still);
}
