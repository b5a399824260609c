#include "remeshing/crease_lines.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace whittle {

namespace {

/// Cosine of the turn at which a line has a corner, 40°: finer bends are held by the deviation that is allowed.
constexpr double kSharpTurn = 0.77;

Vec3 pointOf(const TriangleMesh& mesh, Index v) { return mesh.positions.row(v).transpose(); }

}  // namespace

CreaseLines::CreaseLines(const TriangleMesh& mesh, const MeshEdges& edges, const std::vector<bool>& isCrease,
                         std::vector<bool> isCorner)
    : ofEdges_(edges.count(), kNone), ofVertices_(mesh.vertexCount(), kNone), along_(mesh.vertexCount(), 0) {
  gather(edges, isCrease);
  findCorners(mesh, isCorner);
  cutLoops(mesh, isCorner);
  for (Index v = 0; v < mesh.vertexCount(); ++v) {
    if (!isCorner[v]) continue;
    ofVertices_[v] = kCorner;
    for (Index p = start_[v]; p < start_[v + 1]; ++p) {
      if (ofEdges_[ends_[p].edge] == kNone) add(mesh, v, ends_[p].edge, isCorner);
    }
  }
}

void CreaseLines::gather(const MeshEdges& edges, const std::vector<bool>& isCrease) {
  start_.assign(ofVertices_.size() + 1, 0);
  for (Index e = 0; e < edges.count(); ++e) {
    if (!isCrease[e]) continue;
    for (const Index v : edges.ends[e]) ++start_[v + 1];
  }
  std::partial_sum(start_.begin(), start_.end(), start_.begin());
  ends_.resize(start_.back());
  std::vector<Index> next(start_.begin(), start_.end() - 1);
  for (Index e = 0; e < edges.count(); ++e) {
    if (!isCrease[e]) continue;
    const auto [a, b] = edges.ends[e];
    ends_[next[a]++] = {b, e};
    ends_[next[b]++] = {a, e};
  }
}

void CreaseLines::findCorners(const TriangleMesh& mesh, std::vector<bool>& isCorner) const {
  for (Index v = 0; v < mesh.vertexCount(); ++v) {
    const Index count = start_[v + 1] - start_[v];
    if (count == 0) continue;
    if (count != 2) {
      isCorner[v] = true;
      continue;
    }
    const Vec3 in = pointOf(mesh, v) - pointOf(mesh, ends_[start_[v]].vertex),
               out = pointOf(mesh, ends_[start_[v] + 1].vertex) - pointOf(mesh, v);
    if (in.dot(out) < kSharpTurn * in.norm() * out.norm()) isCorner[v] = true;
  }
}

std::vector<Index> CreaseLines::walk(Index vertex, Index edge, const std::vector<bool>& isCorner) const {
  std::vector<Index> way = {vertex};
  Index v = vertex;
  do {
    Index p = start_[v];
    while (ends_[p].edge != edge) ++p;
    v = ends_[p].vertex;
    way.push_back(v);
    if (!isCorner[v]) edge = ends_[start_[v]].edge == edge ? ends_[start_[v] + 1].edge : ends_[start_[v]].edge;
  } while (v != vertex && !isCorner[v]);
  return way;
}

void CreaseLines::cutLoops(const TriangleMesh& mesh, std::vector<bool>& isCorner) const {
  std::vector<bool> isSeen(isCorner.size(), false);
  const auto cut = [&](Index v, Index edge) {
    const std::vector<Index> way = walk(v, edge, isCorner);
    double length = 0;
    for (std::size_t i = 0; i < way.size(); ++i) {
      isSeen[way[i]] = true;
      if (i > 0) length += (pointOf(mesh, way[i]) - pointOf(mesh, way[i - 1])).norm();
    }
    if (way.back() != v) return;
    double along = 0;
    int cuts = 1;
    const std::size_t count = way.size() - 1;  // vertices, three at least
    isCorner[v] = true;
    for (std::size_t i = 1; i < count && cuts < 3; ++i) {
      along += (pointOf(mesh, way[i]) - pointOf(mesh, way[i - 1])).norm();
      if (along < length * cuts / 3 && count - i > static_cast<std::size_t>(3 - cuts)) continue;
      isCorner[way[i]] = true;
      ++cuts;
    }
  };
  const Index vertexCount = mesh.vertexCount();
  for (Index v = 0; v < vertexCount; ++v) {
    if (!isCorner[v]) continue;
    for (Index p = start_[v]; p < start_[v + 1]; ++p) cut(v, ends_[p].edge);
  }
  for (Index v = 0; v < vertexCount; ++v) {
    if (!isCorner[v] && !isSeen[v] && start_[v + 1] - start_[v] == 2) cut(v, ends_[start_[v]].edge);
  }
}

void CreaseLines::add(const TriangleMesh& mesh, Index vertex, Index edge, const std::vector<bool>& isCorner) {
  const std::vector<Index> way = walk(vertex, edge, isCorner);
  const Index line = static_cast<Index>(lines_.size());
  Line result{vertex, way.back(), {pointOf(mesh, vertex)}, {0}};
  for (std::size_t i = 1; i < way.size(); ++i) {
    Index p = start_[way[i - 1]];
    while (ends_[p].vertex != way[i] || (i == 1 && ends_[p].edge != edge)) ++p;
    ofEdges_[ends_[p].edge] = line;
    result.points.push_back(pointOf(mesh, way[i]));
    result.along.push_back(result.along.back() + (result.points[i] - result.points[i - 1]).norm());
    if (isCorner[way[i]]) continue;
    ofVertices_[way[i]] = line;
    along_[way[i]] = result.along.back();
  }
  lines_.push_back(std::move(result));
}

Vec3 CreaseLines::at(Index line, double place) const {
  const auto& [first, last, points, along] = lines_[line];
  const auto next = std::upper_bound(along.begin() + 1, along.end() - 1, place);
  const std::size_t i = next - along.begin();
  const double step = along[i] - along[i - 1];
  const double share = step > 0 ? std::clamp((place - along[i - 1]) / step, 0.0, 1.0) : 0;
  return points[i - 1] + share * (points[i] - points[i - 1]);
}

double CreaseLines::deviation(Index line, double from, double to) const {
  if (from > to) std::swap(from, to);
  const auto& [first, last, points, along] = lines_[line];
  const Vec3 a = at(line, from), way = at(line, to) - a;
  const double square = way.squaredNorm();
  double most = 0;
  for (std::size_t i = std::upper_bound(along.begin(), along.end(), from) - along.begin();
       i < along.size() && along[i] < to; ++i) {
    const Vec3 off = points[i] - a;
    const double share = square > 0 ? std::clamp(off.dot(way) / square, 0.0, 1.0) : 0;
    most = std::max(most, (off - share * way).norm());
  }
  return most;
}

}  // namespace whittle
