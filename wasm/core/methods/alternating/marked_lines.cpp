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

}  // namespace whittle
