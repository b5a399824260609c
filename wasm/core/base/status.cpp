#include "base/status.h"

namespace whittle {

const char* codeName(Code code) {
  switch (code) {
    case Code::ok: return "ok";
    case Code::noFaces: return "no-faces";
    case Code::indexOutOfRange: return "index-out-of-range";
    case Code::notFinite: return "not-finite";
    case Code::zeroExtent: return "zero-extent";
    case Code::tooLarge: return "too-large";
    case Code::unsuitableMesh: return "unsuitable-mesh";
    case Code::unknownMethod: return "unknown-method";
    case Code::badParameter: return "bad-parameter";
    case Code::badHandles: return "bad-handles";
    case Code::numericalFailure: return "numerical-failure";
  }
  return "internal";
}

}  // namespace whittle
