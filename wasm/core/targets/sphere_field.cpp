#include "targets/sphere_field.h"

#include <cmath>

namespace whittle {

double SphereField::at(Index row, Index column) const {
  if (row < 0 || row >= height) {  // beyond a pole the sphere goes on on the other side
    row = row < 0 ? -1 - row : 2 * height - 1 - row;
    column += height;
  }
  return values[row * width() + (column + width()) % width()];
}

double SphereField::operator()(const Vec3& direction) const {
  const double phi = std::atan2(direction.x(), direction.z());
  const double theta = std::atan2(std::hypot(direction.x(), direction.z()), direction.y());
  const double across = (phi / (2 * EIGEN_PI) + 0.5) * width() - 0.5;
  const double down = theta / EIGEN_PI * height - 0.5;
  const double left = std::floor(across), top = std::floor(down);
  const double x = across - left, y = down - top;
  const Index column = static_cast<Index>(left), row = static_cast<Index>(top);
  const auto along = [&](Index r) {
    const double from = at(r, column), to = at(r, column + 1);
    return from + x * (to - from);  // of equal ones their very bits
  };
  const double above = along(row), below = along(row + 1);
  return above + y * (below - above);
}

bool operator==(const SphereField& a, const SphereField& b) {
  return a.height == b.height && a.values.size() == b.values.size() && a.values == b.values;
}

Status validateSphereField(const SphereField& field, Index width) {
  const auto refused = [](const std::string& what, Element element = {}) {
    return Status::failure(Code::badParameter, "a field on the Gauss map " + what, element);
  };
  if (field.height < SphereField::kLeastHeight || field.height > SphereField::kMostHeight || width != field.width())
    return refused("must be twice as wide as high, and from " + std::to_string(SphereField::kLeastHeight) + " to " +
                   std::to_string(SphereField::kMostHeight) + " high");
  if (field.values.size() != Eigen::Index(width) * field.height) return refused("must have a number for each pixel");
  for (Index k = 0; k < field.values.size(); ++k) {
    if (!(field.values[k] >= 0 && field.values[k] <= 1))
      return refused("must hold numbers from 0 to 1; number {} is none", Element::item(k));
  }
  return {};
}

}  // namespace whittle
