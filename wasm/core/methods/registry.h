#pragma once

#include <string>
#include <vector>

#include "methods/method.h"

namespace whittle {

/// All methods of the core. A new method is one policy and one line here.
const std::vector<MethodInfo>& methodRegistry();

/// The line of a method, or nullptr.
const MethodInfo* findMethod(const std::string& id);

/// The registry as JSON, for TypeScript to hold against its descriptors: [{"id", "parameters": what
/// `ParameterValues::describe` says}].
std::string describeMethods();

}  // namespace whittle
