#pragma once

#include <functional>
#include <string>
#include <vector>

#include "base/types.h"

namespace whittle {

/// A number for each vertex or face that a method can show while it works.
struct Field {
  enum class Per { vertex, face };

  const char* name;   // for programs: "size"
  const char* label;  // for people: "Change of size"
  Per per;
  const char* unit;  // of its numbers: "×", "°", or "" where they have none
  /// Writes the numbers, #V in the method's order or #F.
  std::function<void(Scalars& values)> write;
};

/// Fields as JSON: [{"name", "label", "per": "vertex" or "face", "unit"}].
std::string describeFields(const std::vector<Field>& fields);

}  // namespace whittle
