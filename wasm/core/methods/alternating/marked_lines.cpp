#include "methods/alternating/marked_lines.h"

#include <algorithm>

#include "geometry/box_tree.h"

namespace whittle {

namespace {

struct Segment {
  Vec3 from, to;

  /// Share of the way at which a point lies nearest, 0 to 1.
  double along(const Vec3& p) const {
    const Vec3 way = to - from;
    const double squared = way.squaredNorm();
    return squared > 0 ? std::clamp((p - from).dot(way) / squared, 0.0, 1.0) : 0;
  }
  bool holds(const Vec3& p) const { return (from + along(p) * (to - from) - p).norm() <= kOnLine; }
  Box box() const {
    Box result(from.cwiseMin(to), from.cwiseMax(to));
    return Box(result.min().array() - kOnLine, result.max().array() + kOnLine);
  }
};

/// How many of the segments have an edge along them.
std::size_t countOnEdges(const std::vector<Segment>& segments, const Points& positions, const MeshEdges& edges) {
  std::vector<bool> isMet(segments.size(), false);
  for (const auto& [low, high] : edges.ends) {
    const Vec3 a = positions.row(low).transpose(), b = positions.row(high).transpose();
    for (std::size_t s = 0; s < segments.size(); ++s)
      isMet[s] = isMet[s] || (segments[s].holds(a) && segments[s].holds(b));
  }
  return static_cast<std::size_t>(std::count(isMet.begin(), isMet.end(), true));
}

std::string lineOf(const char* name, std::size_t line) {
  std::string words = "Line ";
  return words.append(std::to_string(line + 1)).append(" of “").append(name).append("” ");
}

constexpr const char* kAlongNone = "lies along no edge of the mesh, so that it marks nothing.";

std::vector<Segment> segmentsOf(const std::vector<Index>& chain, const Points& input) {
  std::vector<Segment> segments;
  for (std::size_t i = 1; i < chain.size(); ++i)
    segments.push_back({input.row(chain[i - 1]).transpose(), input.row(chain[i]).transpose()});
  return segments;
}

}  // namespace

std::vector<bool> edgesAlong(const VertexChains& chains, const Points& input, const RestSurface& surface) {
  std::vector<Segment> segments;
  for (const std::vector<Index>& chain : chains) {
    const std::vector<Segment> own = segmentsOf(chain, input);
    segments.insert(segments.end(), own.begin(), own.end());
  }
  if (segments.empty()) return {};
  std::vector<Box> boxes;
  for (const Segment& segment : segments) boxes.push_back(segment.box());
  BoxTree tree(boxes);
  while (!tree.buildNext(segments.size())) {
  }
  std::vector<bool> result(surface.edges.count(), false);
  for (Index e = 0; e < surface.edges.count(); ++e) {
    const Vec3 a = surface.mesh.positions.row(surface.edges.ends[e][0]).transpose();
    const Vec3 b = surface.mesh.positions.row(surface.edges.ends[e][1]).transpose();
    const auto isOn = [&](const Vec3& p) {
      return tree.findIn(Box(p, p), [&](Index s) { return segments[s].holds(p); });
    };
    result[e] = isOn(a) && isOn(b) && isOn(0.5 * (a + b));
  }
  return result;
}

VertexChains chainsAlong(const VertexChains& chains, const Points& input, const RestSurface& surface) {
  VertexChains result;
  for (const std::vector<Index>& chain : chains) {
    const std::vector<Segment> segments = segmentsOf(chain, input);
    std::vector<std::pair<double, Index>> found;  // way along the chain, vertex
    for (Index v = 0; v < surface.vertexCount(); ++v) {
      const Vec3 p = surface.mesh.positions.row(v).transpose();
      for (std::size_t s = 0; s < segments.size(); ++s) {
        if (!segments[s].holds(p)) continue;
        found.emplace_back(static_cast<double>(s) + segments[s].along(p), v);
        break;
      }
    }
    std::sort(found.begin(), found.end());
    std::vector<Index> vertices;
    for (const auto& [way, v] : found) vertices.push_back(v);
    if (vertices.size() > 2) result.push_back(std::move(vertices));
  }
  return result;
}

std::vector<std::string> linesOffEdges(const char* name, const VertexChains& chains, const TriangleMesh& input) {
  std::vector<std::string> sentences;
  if (chains.empty()) return sentences;
  const MeshEdges edges(input.triangles, input.vertexCount());
  for (std::size_t line = 0; line < chains.size(); ++line) {
    const std::vector<Segment> segments = segmentsOf(chains[line], input.positions);
    const std::size_t met = countOnEdges(segments, input.positions, edges);
    if (met == 0) {
      sentences.push_back(lineOf(name, line) + kAlongNone);
    } else if (met < segments.size()) {
      sentences.push_back(lineOf(name, line) + "leaves the edges of the mesh; it marks those that it lies along.");
    }
  }
  return sentences;
}

std::vector<std::string> linesKeptByNothing(const char* name, const VertexChains& chains, const TriangleMesh& input,
                                            const RestSurface& surface) {
  std::vector<std::string> sentences;
  for (std::size_t line = 0; line < chains.size(); ++line) {
    if (!chainsAlong({chains[line]}, input.positions, surface).empty()) continue;
    const MeshEdges edges(input.triangles, input.vertexCount());
    const bool isOnEdges = countOnEdges(segmentsOf(chains[line], input.positions), input.positions, edges) > 0;
    sentences.push_back(lineOf(name, line) +
                        (isOnEdges ? "has fewer than three vertices where the work is done, so that it keeps nothing "
                                     "straight."
                                   : kAlongNone));
  }
  return sentences;
}

}  // namespace whittle
