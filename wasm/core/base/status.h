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
  badPlanes,
  numericalFailure,
};

/// The name that TypeScript knows the code by, e.g. "index-out-of-range".
const char* codeName(Code code);

/// What a failure is about.
struct Element {
  enum class Kind {
    none,
    vertex,
    face,
    item,  // of the value that was refused, e.g. a normal of a Gauss map
  };

  Kind kind = Kind::none;
  Index index = -1;

  static Element vertex(Index index) { return {Kind::vertex, index}; }
  static Element face(Index index) { return {Kind::face, index}; }
  static Element item(Index index) { return {Kind::item, index}; }
};

/// The result of everything that can fail: a code, a sentence for a person and the element it is about. Where the
/// sentence names the element it has `kPlace` for its number, which is filled in once, in the numbering of the file
/// (`Session`).
struct [[nodiscard]] Status {
  static constexpr const char* kPlace = "{}";

  Code code = Code::ok;
  std::string message;
  Element element;

  bool ok() const { return code == Code::ok; }

  static Status failure(Code code, std::string message, Element element = {}) {
    return {code, std::move(message), element};
  }

  /// The failure with `number` for its element, also in the sentence.
  Status numbered(Index number) const;
};

}  // namespace whittle
