#pragma once

#include "constraints/handles.h"
#include "constraints/straight_chains.h"
#include "methods/parts.h"

namespace whittle {

/// What is kept of the shape while handles move.
enum class Variant {
  slippage,   // directions of faces, and how the surface slides in itself: holes, edges, round parts
  alup,       // directions, and the same scale all around: as locally uniform as possible (§3)
  poisson,    // edge vectors: one linear solve
  arap,       // sizes: as rigid as possible
  conformal,  // angles
};

/// Whether the print is followed to the letter.
enum class Reading { tuned, published };

/// When faces are cut anew inside.
enum class Remesh { automatic, never, always };

struct ReshapeParameters {
  Variant variant = Variant::slippage;
  Reading reading = Reading::tuned;
  Handles handles;
  double featureAngle = 40;  // degrees by which faces bend along a feature edge
  VertexChains features;     // chains of edges that are features whatever their angle
  VertexChains smooth;       // chains of edges that are none
  VertexChains straight;     // chains that stay straight
  bool finalize = true;      // whether errors next to handles are spread over their surroundings
  Remesh remesh = Remesh::automatic;
  Parts parts = Parts::together;
  int maxIterations = 100;
};

}  // namespace whittle
