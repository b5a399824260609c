#include <doctest/doctest.h>

#include <cmath>

#include "support/rows.h"
#include "support/systems.h"
#include "targets/sphere_field.h"

using namespace whittle;
using namespace whittle::testing;

namespace {

/// The direction of a pixel's centre.
Vec3 centre(Index row, Index column, Index height) {
  const double theta = EIGEN_PI * (row + 0.5) / height, phi = 2 * EIGEN_PI * ((column + 0.5) / (2 * height) - 0.5);
  return {std::sin(theta) * std::sin(phi), std::cos(theta), std::sin(theta) * std::cos(phi)};
}

template <typename Of>
SphereField field(Index height, Of&& of) {
  SphereField result{height, Scalars(2 * height * height)};
  for (Index k = 0; k < result.values.size(); ++k) result.values[k] = of(k / (2 * height), k % (2 * height));
  return result;
}

}  // namespace

TEST_CASE("a field on the sphere has at the centre of each pixel what stands there, at any length") {
  Noise noise;
  for (const Index height : {2, 3, 16}) {
    const SphereField some = field(height, [&](Index, Index) { return 0.5 + 0.5 * noise(); });
    for (Index row = 0; row < height; ++row) {
      for (Index column = 0; column < 2 * height; ++column) {
        const double expected = some.values[row * 2 * height + column];
        CHECK(some(3 * centre(row, column, height)) == doctest::Approx(expected).epsilon(1e-12));
      }
    }
  }
}

TEST_CASE("up is the top row, z the middle, x to its right, and a constant keeps its bits") {
  const Index height = 32;
  const SphereField up = field(height, [&](Index row, Index) { return row < height / 2 ? 1.0 : 0.0; });
  CHECK(up(Vec3(0.1, 1, -0.3)) == 1);
  CHECK(up(Vec3(0.1, -1, -0.3)) == 0);
  const SphereField right = field(height, [&](Index, Index column) { return column < height ? 0.0 : 1.0; });
  CHECK(right(Vec3(1, 0.2, 0.3)) == 1);
  CHECK(right(Vec3(-1, 0.2, 0.3)) == 0);
  CHECK(right(Vec3(0, 0.5, 1)) == 0.5);
  CHECK(right(Vec3(0, 0.5, -1)) == 0.5);
  Noise noise;
  for (const double value : {0.0, 1.0, 0.3}) {
    const SphereField constant = field(5, [&](Index, Index) { return value; });
    for (const Vec3& axis : {Vec3(0, 1, 0), Vec3(0, -1, 0), Vec3(0, 0, -1)}) CHECK(constant(axis) == value);
    for (int k = 0; k < 100; ++k) CHECK(constant(noise.direction()) == value);
  }
}

TEST_CASE("a field on the sphere is continuous over its edges, and over the poles but for a share of a pixel") {
  const Index height = 64;
  const auto smooth = [](const Vec3& n) { return 0.5 + 0.2 * n.x() + 0.1 * n.y() * n.z() - 0.2 * n.z(); };
  const SphereField some = field(height, [&](Index row, Index column) { return smooth(centre(row, column, height)); });
  Noise noise;
  for (int k = 0; k < 2000; ++k) {
    Vec3 n = noise.direction();
    if (k % 3 == 0) n = (Vec3(0, k % 2 ? 1 : -1, 0) + 0.02 * n).normalized();
    CHECK(std::abs(some(n) - smooth(n)) < 1e-3);
  }
}
