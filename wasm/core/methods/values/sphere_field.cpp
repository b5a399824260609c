#include "methods/values/sphere_field.h"

namespace whittle {

Status SphereFieldKind::read(const RawValue& raw, const MeshContext&, Value& value) const {
  if (raw.hasName() || raw.indices.size() != 2) return raw.refused("must have a width, a height and its numbers");
  const Eigen::Index count = static_cast<Eigen::Index>(raw.numbers.size());
  SphereField field{raw.indices[1], Eigen::Map<const Scalars>(raw.numbers.data(), count)};
  if (Status status = validateSphereField(field, raw.indices[0]); !status.ok()) return status;
  if (value && *value == field) return {};
  value = std::make_shared<const SphereField>(std::move(field));
  return {};
}

EncodedValue encoded(const SphereField& field) {
  EncodedValue value = encoded(field.values);
  value.indices = {field.width(), field.height};
  return value;
}

}  // namespace whittle
