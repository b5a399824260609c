#pragma once

#include "methods/values/choice.h"

namespace whittle {

/// What parts do that touch each other.
enum class Parts {
  together,  // they stay in touch, see `Attachments`
  free,      // each is shaped as if it were alone
};

/// The kind of the parameter `parts`.
inline ChoiceKind<Parts> waysOfParts() { return {{{"together", Parts::together}, {"free", Parts::free}}}; }

}  // namespace whittle
