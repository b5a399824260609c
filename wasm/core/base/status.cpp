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
    case Code::badPlanes: return "bad-planes";
    case Code::numericalFailure: return "numerical-failure";
  }
  return "internal";
}

Status Status::numbered(Index number) const {
  Status result = *this;
  result.element.index = number;
  const std::string place = kPlace;
  for (std::size_t at = result.message.find(place); at != std::string::npos; at = result.message.find(place, at)) {
    result.message.replace(at, place.size(), std::to_string(number));
  }
  return result;
}

}  // namespace whittle
