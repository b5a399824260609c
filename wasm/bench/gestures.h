#pragma once

#include <string>
#include <vector>

#include "constraints/handles.h"
#include "mesh/triangle_mesh.h"

namespace whittle::bench {

/// What a person does to a shape.
struct Gesture {
  std::string name;
  TriangleMesh mesh;
  Handles handles;
};

/// Shapes of about so many faces and what is done to them: a plate with five holes is lengthened and shortened, a
/// cylinder lengthened by its caps and by their middles, an arm of a bracket lengthened, a ball pulled at its poles.
std::vector<Gesture> gestures(Index faces);

/// The first of them alone.
Gesture plateGesture(Index faces);

}  // namespace whittle::bench
