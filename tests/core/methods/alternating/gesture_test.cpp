#include "methods/alternating/gesture.h"

#include <doctest/doctest.h>

using namespace whittle;

TEST_CASE("a gesture that goes straight on is a multiple of the one before") {
  const std::vector<Vec3> before{{0, 0, 0}, {1, 0, 0}, {1, 0.5, 0}};
  std::vector<Vec3> now = before;
  for (Vec3& move : now) move *= 1.75;
  CHECK(shareOfGesture(before, now).value() == doctest::Approx(1.75));
  now[2] += Vec3(0, 0, 0.2);
  CHECK(shareOfGesture(before, now).value() == doctest::Approx(1.75));
}

TEST_CASE("a gesture that turns, goes back or leads far away is another one") {
  const std::vector<Vec3> before{{0, 0, 0}, {1, 0, 0}};
  CHECK_FALSE(shareOfGesture(before, {{0, 0, 0}, {1, 0.5, 0}}));
  CHECK_FALSE(shareOfGesture(before, {{0, 0, 0}, {-0.5, 0, 0}}));
  CHECK_FALSE(shareOfGesture(before, {{0, 0, 0}, {4, 0, 0}}));
  CHECK_FALSE(shareOfGesture(before, {{1, 0, 0}}));
  CHECK_FALSE(shareOfGesture({{0, 0, 0}, {0, 0, 0}}, before));
}
