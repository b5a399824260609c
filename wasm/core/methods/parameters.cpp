#include "methods/parameters.h"

#include <cmath>

namespace whittle {

namespace {

const Eigen::Vector4d kIdentity(0, 0, 0, 1);

Status refused(const ParameterInfo& info, const std::string& what, Index element = -1) {
  return Status::failure(Code::badParameter, info.name + (" " + what), element);
}

std::string numbersFor(Index numbers, Index vertices) {
  return "has " + std::to_string(numbers) + " numbers for " + std::to_string(vertices) + " vertices";
}

bool isInRange(const ParameterInfo& info, double value) { return value >= info.min && value <= info.max; }

Status validateVector(const ParameterInfo& info, const Scalars& values) {
  if (values.size() != info.count) {
    return refused(info, "has " + std::to_string(values.size()) + " numbers; it needs " + std::to_string(info.count));
  }
  for (const double value : values) {
    if (!isInRange(info, value)) return refused(info, "is out of its range");
  }
  return {};
}

Status validateRotation(const ParameterInfo& info, const Scalars& values) {
  if (values.size() == 4 && values.allFinite() && !values.isZero(0)) return {};
  return refused(info, "must be a quaternion x y z w of finite numbers, not all of them zero");
}

Status validatePerVertex(const ParameterInfo& info, const Scalars& values, Index vertexCount) {
  if (values.size() != 0 && values.size() != vertexCount) return refused(info, numbersFor(static_cast<Index>(values.size()), vertexCount));
  for (Index v = 0; v < values.size(); ++v) {
    if (!isInRange(info, values[v])) return refused(info, "is out of its range at vertex " + std::to_string(v), v);
  }
  return {};
}

Status validateRotations(const ParameterInfo& info, const Scalars& values, Index vertexCount) {
  if (values.size() != 0 && values.size() != 4 * vertexCount) {
    return refused(info, numbersFor(static_cast<Index>(values.size()), vertexCount) + "; it needs four for each");
  }
  for (Index v = 0; 4 * v < values.size(); ++v) {
    if (!values.segment<4>(4 * v).allFinite()) return refused(info, "is not finite at vertex " + std::to_string(v), v);
  }
  return {};
}

Status validateRows(const ParameterInfo& info, const Scalars& values) {
  const Index rows = static_cast<Index>(values.size() / 3);
  if (values.size() % 3 != 0 || rows > info.count) {
    return refused(info, "must have " + std::to_string(info.count) + " rows of three numbers at most");
  }
  for (Index row = 0; row < rows; ++row) {
    const double length = values.segment<3>(3 * row).norm();
    if (!(length >= kShortestRow && length <= kLongestRow)) {
      return refused(info, "must have rows from 0.001 to 100 long; row " + std::to_string(row) + " is not");
    }
  }
  return {};
}

}  // namespace

Settings Settings::defaults(const std::vector<ParameterInfo>& infos) {
  Settings settings;
  settings.scalars.resize(infos.size());
  for (std::size_t p = 0; p < infos.size(); ++p) {
    settings.numbers.push_back(infos[p].defaultValue);
    if (infos[p].kind == ParameterKind::vector) settings.scalars[p] = Scalars::Constant(infos[p].count, infos[p].defaultValue);
    if (infos[p].kind == ParameterKind::rotation) settings.scalars[p] = kIdentity;
  }
  return settings;
}

Status validateScalars(const ParameterInfo& info, const Scalars& values, Index vertexCount) {
  switch (info.kind) {
    case ParameterKind::vector: return validateVector(info, values);
    case ParameterKind::rotation: return validateRotation(info, values);
    case ParameterKind::rotations: return validateRotations(info, values, vertexCount);
    case ParameterKind::choice: return validateRows(info, values);
    default: return validatePerVertex(info, values, vertexCount);
  }
}

Status validateNumber(const ParameterInfo& info, double value) {
  const bool whole = value == std::trunc(value);
  if (isInRange(info, value) && (info.kind == ParameterKind::number || whole)) return {};
  return refused(info, "is out of its range");
}

}  // namespace whittle
