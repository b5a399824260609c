#pragma once

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "base/status.h"
#include "constraints/handles.h"

namespace whittle {

/// What a change of a parameter makes stale; each level includes those before it.
enum class Stale { nothing, targets, weights, system, all };

enum class ParameterKind { number, integer, choice, handles };

/// One parameter of a method: the C++ twin of the TypeScript descriptor, held against it by a test.
struct ParameterInfo {
  const char* name;
  ParameterKind kind;
  Stale invalidates;
  double defaultValue = 0;  // not of handles; of a choice, its index
  double min = 0;           // hard range, inclusive
  double max = 0;
  std::vector<const char*> choices = {};  // names by index, for a choice only
};

/// One of several named ways, the first by default. Its value is the index of the name.
inline ParameterInfo choiceParameter(const char* name, Stale invalidates, std::vector<const char*> choices) {
  const double last = static_cast<double>(choices.size()) - 1;
  return {name, ParameterKind::choice, invalidates, 0, 0, last, std::move(choices)};
}

/// Values for a method's parameters, in the order of its ParameterInfo list; handles beside them, in the unit frame.
struct Settings {
  std::vector<double> numbers;
  Handles handles;

  static Settings defaults(const std::vector<ParameterInfo>& infos) {
    Settings settings;
    for (const ParameterInfo& info : infos) settings.numbers.push_back(info.defaultValue);
    return settings;
  }
};

/// Fails with `badParameter`, naming the parameter, if the value is not finite, out of range or not whole.
inline Status validateNumber(const ParameterInfo& info, double value) {
  const bool whole = value == std::trunc(value);
  if (value >= info.min && value <= info.max && (info.kind == ParameterKind::number || whole)) return {};
  return Status::failure(Code::badParameter, std::string(info.name) + " is out of its range");
}

}  // namespace whittle
