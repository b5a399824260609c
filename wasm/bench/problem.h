#pragma once

#include <string>
#include <vector>

#include "reference/plain_local_global.h"
#include "session/session.h"

namespace whittle::bench {

/// What is to be solved, in the unit frame.
struct Problem {
  std::string method;
  TriangleMesh mesh;
  PlainProblem plain;  // of methods that have a plain path

  bool hasPlainPath() const;
};

/// The methods that there is a problem for.
const std::vector<std::string>& problemNames();

/// Reads int32 vertex and face counts, float64 positions #V×3 and int32 triangles #F×3 from a file. `cubic` is at λ
/// 0.4, `analogy` takes the style of a cube at λ 1 with constant targets; for `arap` the lower tenth of the longest
/// axis stays and the upper tenth turns; `normalmap` raises waves, `polycube` turns to the sides of a cube,
/// `developable` is as it comes. Ends the program where the file is short.
Problem readProblem(const std::string& method, const char* path);

/// Loads a problem into a session and chooses method and parameters; no tolerance where there is a plain path, the
/// default acceleration.
Status open(Session& session, const Problem& problem);

}  // namespace whittle::bench
