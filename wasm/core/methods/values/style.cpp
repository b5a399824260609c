#include "methods/values/style.h"

#include "methods/values/choice.h"

namespace whittle {

namespace {

using Form = GaussMapData::Kind;

const ChoiceKind<Form> kForms{{{"closest", Form::closest}, {"vertex", Form::perVertex}, {"face", Form::perFace}}};

/// Takes the value apart; what it holds is for `validateGaussMap` to judge.
Status decode(const RawValue& raw, GaussMapData& data) {
  const std::size_t pointCount = raw.indices.empty() ? 0 : static_cast<std::size_t>(std::max<Index>(raw.indices[0], 0));
  const std::size_t cornerCount = raw.indices.empty() ? 0 : raw.indices.size() - 1;
  if (raw.numbers.size() % 3 != 0 || cornerCount % 3 != 0 || raw.numbers.size() < 3 * pointCount) {
    return raw.refused("must have three numbers for each point and normal, and three points for each triangle");
  }
  const std::size_t normalCount = raw.numbers.size() / 3 - pointCount;
  data.points = Eigen::Map<const Points>(raw.numbers.data(), pointCount, 3);
  data.normals = Eigen::Map<const Points>(raw.numbers.data() + 3 * pointCount, normalCount, 3);
  if (cornerCount > 0) data.triangles = Eigen::Map<const Triangles>(raw.indices.data() + 1, cornerCount / 3, 3);
  return {};
}

}  // namespace

Status StyleKind::read(const RawValue& raw, const MeshContext& mesh, Value& value) const {
  GaussMapData data;
  const RawValue form{.parameter = raw.parameter, .name = raw.name};
  if (Status status = kForms.read(form, mesh, data.kind); !status.ok()) return status;
  if (Status status = decode(raw, data); !status.ok()) return status;
  if (value && value->data() == data) return {};  // the map is there already
  if (Status status = validateGaussMap(data); !status.ok()) return status;
  value = std::make_shared<const GaussMap>(std::move(data));
  return {};
}

EncodedValue encoded(const GaussMapData& data) {
  EncodedValue value;
  for (const auto& [name, form] : kForms.choices) {
    if (form == data.kind) value.name = name;
  }
  value.append(data.points).append(data.normals);
  if (data.kind == Form::closest) return value;
  value.indices.push_back(static_cast<Index>(data.points.rows()));
  value.indices.insert(value.indices.end(), data.triangles.data(), data.triangles.data() + data.triangles.size());
  return value;
}

}  // namespace whittle
