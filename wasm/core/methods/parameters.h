#pragma once

#include <cmath>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "base/status.h"
#include "constraints/handles.h"
#include "geometry/gauss_map.h"
#include "geometry/relief.h"

namespace whittle {

/// What a change of a parameter makes stale; each level includes those before it.
enum class Stale { nothing, targets, weights, system, all };

enum class ParameterKind {
  number,
  integer,
  choice,
  flag,     // 0 or 1
  scalars,  // a number for each vertex, or none
  style,    // a Gauss map
  relief,   // a texture's slopes
  handles,
};

/// One parameter of a method: the C++ twin of the TypeScript descriptor, held against it by a test.
struct ParameterInfo {
  const char* name;
  ParameterKind kind;
  Stale invalidates;
  double defaultValue = 0;  // of what is one number; of a choice, its index
  double min = 0;           // hard range, inclusive, of each number
  double max = 0;
  std::vector<const char*> choices = {};  // names by index, for a choice only

  /// Whether its value is one of `Settings::numbers`.
  bool isNumber() const { return kind < ParameterKind::scalars; }
};

/// One of several named ways, the first by default. Its value is the index of the name.
inline ParameterInfo choiceParameter(const char* name, Stale invalidates, std::vector<const char*> choices) {
  const double last = static_cast<double>(choices.size()) - 1;
  return {name, ParameterKind::choice, invalidates, 0, 0, last, std::move(choices)};
}

/// Something that is done or not, by default not.
inline ParameterInfo flagParameter(const char* name, Stale invalidates) {
  return {name, ParameterKind::flag, invalidates, 0, 0, 1};
}

/// Values for a method's parameters, in the order of its ParameterInfo list; handles beside them, in the unit frame, the style and the relief.
struct Settings {
  std::vector<double> numbers;
  std::vector<Scalars> scalars;  // #V, or empty where there are none
  Handles handles;
  std::shared_ptr<const GaussMap> style;  // nullptr: none
  std::shared_ptr<const Relief> relief;   // nullptr: none

  static Settings defaults(const std::vector<ParameterInfo>& infos) {
    Settings settings;
    for (const ParameterInfo& info : infos) settings.numbers.push_back(info.defaultValue);
    settings.scalars.resize(infos.size());
    return settings;
  }
};

/// Fails with `badParameter`, naming the parameter, if there is neither a number for each vertex nor none, or one is out of range (element: its vertex).
inline Status validateScalars(const ParameterInfo& info, const Scalars& values, Index vertexCount) {
  const auto refused = [&](const std::string& what, Index element = -1) {
    return Status::failure(Code::badParameter, info.name + what, element);
  };
  if (values.size() != 0 && values.size() != vertexCount) {
    return refused(" has " + std::to_string(values.size()) + " numbers for " + std::to_string(vertexCount) + " vertices");
  }
  for (Index v = 0; v < values.size(); ++v) {
    if (!(values[v] >= info.min && values[v] <= info.max)) return refused(" is out of its range at vertex " + std::to_string(v), v);
  }
  return {};
}

/// Fails with `badParameter`, naming the parameter, if the value is not finite, out of range or not whole.
inline Status validateNumber(const ParameterInfo& info, double value) {
  const bool whole = value == std::trunc(value);
  if (value >= info.min && value <= info.max && (info.kind == ParameterKind::number || whole)) return {};
  return Status::failure(Code::badParameter, std::string(info.name) + " is out of its range");
}

}  // namespace whittle
