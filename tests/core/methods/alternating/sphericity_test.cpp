#include "methods/alternating/sphericity.h"

#include <doctest/doctest.h>

#include <cmath>

using namespace whittle;

namespace {

double sphericityOf(double larger, double smaller) {
  Curvatures one{Scalars::Constant(1, larger), Scalars::Constant(1, smaller), Points::Zero(1, 3)};
  return sphericity(one)[0];
}

}  // namespace

TEST_CASE("sphericity is 1 on spheres within the box and less on larger and on dented ones") {
  CHECK(sphericityOf(2, 2) == doctest::Approx(1));
  CHECK(sphericityOf(20, 20) == doctest::Approx(1));
  CHECK(sphericityOf(-2, -2) == doctest::Approx(1));
  CHECK(sphericityOf(1, 1) == doctest::Approx(std::exp(-0.25 / 0.18)));
  CHECK(sphericityOf(5, 4) == doctest::Approx(std::exp(-0.04 / 0.08)).epsilon(1e-3));
}

TEST_CASE("sphericity is nothing on planes, cylinders and saddles") {
  CHECK(sphericityOf(0, 0) == 0);
  CHECK(sphericityOf(0.019, 0.019) == 0);
  CHECK(sphericityOf(0.021, 0.021) > 0);
  CHECK(sphericityOf(4, 0) == 0);
  CHECK(sphericityOf(0, -4) == 0);
  CHECK(sphericityOf(4, 1.9) == 0);
  CHECK(sphericityOf(3, -3) == 0);
}
