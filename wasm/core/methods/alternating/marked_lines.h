#pragma once

#include <string>

#include "constraints/straight_chains.h"
#include "methods/alternating/rest_surface.h"

namespace whittle {

/// Lines that were marked on the input, on a working surface whose edges may be cut otherwise: what lies on them, to
/// `kOnLine` of the longest side.
constexpr double kOnLine = 1e-3;

/// The edges of the surface that lie along chains, #E; empty where there are no chains.
/// @param input #V×3, what the chains' vertices are of
std::vector<bool> edgesAlong(const VertexChains& chains, const Points& input, const RestSurface& surface);

/// The vertices of the surface that lie along each chain, in its order.
VertexChains chainsAlong(const VertexChains& chains, const Points& input, const RestSurface& surface);

/// What is to be said of lines that leave the edges of the input, a sentence each.
/// @param name of the parameter whose lines they are
std::vector<std::string> linesOffEdges(const char* name, const VertexChains& chains, const TriangleMesh& input);

/// What is to be said of lines that keep nothing straight, a sentence each.
std::vector<std::string> linesKeptByNothing(const char* name, const VertexChains& chains, const TriangleMesh& input,
                                            const RestSurface& surface);

}  // namespace whittle
