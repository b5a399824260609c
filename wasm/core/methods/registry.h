#pragma once

#include <string>

#include "methods/method.h"

namespace whittle {

/// All methods of the core. A new method is one policy and one line here.
const std::vector<MethodInfo>& methodRegistry();

/// The line of a method, or nullptr.
const MethodInfo* findMethod(const std::string& id);

/// The registry as JSON, for TypeScript to hold against its descriptors:
/// [{"id", "parameters": [{"name", "kind", "invalidates", "default", "min", "max", "choices", "maxRows"}]}], each only where it applies;
/// the default of a choice is its name, that of a flag true or false.
std::string describeMethods();

}  // namespace whittle
