#pragma once

#include <string>
#include <utility>

#include "base/types.h"

namespace whittle {

/// Why something was refused or failed. Codes cross to TypeScript by `codeName`.
enum class Code {
  ok,
  noFaces,
  indexOutOfRange,
  notFinite,
  zeroExtent,
  tooLarge,
  unsuitableMesh,
  unknownMethod,
  badParameter,
  badHandles,
  numericalFailure,
};

/// The name that TypeScript knows the code by, e.g. "index-out-of-range".
const char* codeName(Code code);

/// The result of everything that can fail: a code, a sentence for a person and the element it is about (−1: none).
struct [[nodiscard]] Status {
  Code code = Code::ok;
  std::string message;
  Index element = -1;

  bool ok() const { return code == Code::ok; }

  static Status failure(Code code, std::string message, Index element = -1) {
    return {code, std::move(message), element};
  }
};

}  // namespace whittle
