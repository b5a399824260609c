#pragma once

#include <functional>
#include <string>
#include <vector>

#include "base/types.h"

namespace whittle {

/// A number for each vertex or face that a method can show while it works, or lines over the mesh.
struct Field {
  enum class Per { vertex, face, line };

  const char* name;   // for programs: "size"
  const char* label;  // for people: "Change of size"
  Per per;
  const char* unit;  // of its numbers: "×", "°", or "" where they have none
  /// Writes the numbers, #V in the method's order or #F; of lines the vertices, 2 `count`.
  std::function<void(Scalars& values)> write;
  Index count = 0;  // of lines
};

/// Fields as JSON: [{"name", "label", "per": "vertex", "face" or "line", "unit", "count": of lines}].
std::string describeFields(const std::vector<Field>& fields);

}  // namespace whittle
