#pragma once

#include <vector>

#include "mesh/edges.h"

namespace whittle {

/// Chains of vertices, each along edges, one after the other.
using VertexChains = std::vector<std::vector<Index>>;

/// The straight chains among feature edges, of 3 vertices and more, by their first edges. An edge goes on in the one
/// that bends by no more than 2° from it; where there are two of them, or more than 16 feature edges at the vertex, it
/// ends. What hangs together so is a chain if it keeps within 2° of its chord. Where it does not, as a line that passes
/// into an arc of small steps, or a rim of 300 sides, only those parts are chains that bend by no more than 0.2°.
/// @param features #E
VertexChains straightChains(const Points& positions, const MeshEdges& edges, const std::vector<bool>& features);

}  // namespace whittle
