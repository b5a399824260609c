#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "base/status.h"
#include "constraints/handles.h"
#include "targets/gauss_map.h"
#include "targets/texture_normals.h"

namespace whittle {

/// What a change of a parameter makes stale; each level includes those before it.
enum class Stale { nothing, targets, weights, system, all };

enum class ParameterKind {
  number,
  integer,
  choice,
  flag,       // 0 or 1
  vector,     // a fixed count of numbers
  rotation,   // a quaternion x y z w of any length but zero, by default the identity
  scalars,    // a number for each vertex, or none
  rotations,  // a quaternion for each vertex, or none; one of zeros says nothing
  style,      // a Gauss map
  textureSlopes,  // a texture's slopes
  handles,
};

/// One parameter of a method: the C++ twin of the TypeScript descriptor, held against it by a test.
struct ParameterInfo {
  const char* name;
  ParameterKind kind;
  Stale invalidates;
  double defaultValue = 0;  // of each number; of a choice, its index
  double min = 0;           // hard range, inclusive, of each number
  double max = 0;
  std::vector<const char*> choices = {};  // names by index, for a choice only
  Index count = 0;  // of a vector, its numbers; of a choice, the rows that it takes at most in place of a name

  /// Whether its value is one of `Settings::numbers`.
  bool isNumber() const { return kind < ParameterKind::vector; }
  /// Whether its value is, or can be, one of `Settings::scalars`.
  bool isScalars() const {
    return kind == ParameterKind::choice ? count > 0 : kind >= ParameterKind::vector && kind <= ParameterKind::rotations;
  }
};

/// One of several named ways, the first by default. Its value is the index of the name.
inline ParameterInfo choiceParameter(const char* name, Stale invalidates, std::vector<const char*> choices) {
  const double last = static_cast<double>(choices.size()) - 1;
  return {name, ParameterKind::choice, invalidates, 0, 0, last, std::move(choices)};
}

/// A choice in place of whose names a matrix of one's own will do: `most` rows of three numbers, or fewer.
inline ParameterInfo choiceOrRowsParameter(const char* name, Stale invalidates, std::vector<const char*> choices, Index most) {
  ParameterInfo info = choiceParameter(name, invalidates, std::move(choices));
  info.count = most;
  return info;
}

/// Some numbers, each of the same default and range.
inline ParameterInfo vectorParameter(const char* name, Stale invalidates, Index count, double usual, double min, double max) {
  return {name, ParameterKind::vector, invalidates, usual, min, max, {}, count};
}

/// Something that is done or not, by default not.
inline ParameterInfo flagParameter(const char* name, Stale invalidates) {
  return {name, ParameterKind::flag, invalidates, 0, 0, 1};
}

/// Values for a method's parameters, in the order of its ParameterInfo list; handles beside them, in the unit frame, the style and the texture slopes.
struct Settings {
  std::vector<double> numbers;
  std::vector<Scalars> scalars;  // by kind: #V, 4·#V, 4, `count` or 3·#rows numbers; empty where there are none
  Handles handles;
  std::shared_ptr<const GaussMap> style;  // nullptr: none
  std::shared_ptr<const TextureSlopes> textureSlopes;   // nullptr: none

  static Settings defaults(const std::vector<ParameterInfo>& infos);
};

/// The shortest and the longest row of a matrix that a choice takes.
constexpr double kShortestRow = 1e-3;
constexpr double kLongestRow = 100;

/// Fails with `badParameter`, naming the parameter, if a list is not of its kind's length or one of its numbers is out of range
/// (element: its vertex, where it has one).
Status validateScalars(const ParameterInfo& info, const Scalars& values, Index vertexCount);

/// Fails with `badParameter`, naming the parameter, if the value is not finite, out of range or not whole.
Status validateNumber(const ParameterInfo& info, double value);

}  // namespace whittle
