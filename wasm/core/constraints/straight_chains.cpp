#include "constraints/straight_chains.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace whittle {

namespace {

constexpr double kMostBend = 2 * EIGEN_PI / 180, kMostBendOfPart = 0.2 * EIGEN_PI / 180;
/// At more than so many feature edges nobody can say which goes on in which, and trying all pairs would take a square.
constexpr Index kMostEdgesAtVertex = 16;
constexpr std::size_t kLeastVertices = 3;

bool bendsLittle(const Vec3& a, const Vec3& b, double limit) {
  return a.cross(b).norm() <= std::sin(limit) * a.norm() * b.norm() && a.dot(b) > 0;
}

/// Follows feature edges from each to the one that goes on from it.
class ChainWalk {
 public:
  /// A way along edges of which each goes on in the next.
  struct Run {
    std::vector<Index> vertices;  // of a closed one without the first again
    bool isClosed = false;
  };

  ChainWalk(const Points& positions, const MeshEdges& edges, const std::vector<bool>& features)
      : positions_(positions), edges_(edges), next_(edges.count(), {-1, -1}), isSeen_(edges.count(), false) {
    std::vector<Index> start(positions.rows() + 2, 0), around;
    for (Index e = 0; e < edges.count(); ++e) {
      if (!features[e]) continue;
      for (const Index v : edges.ends[e]) ++start[v + 2];
    }
    std::partial_sum(start.begin(), start.end(), start.begin());
    around.resize(start.back());
    for (Index e = 0; e < edges.count(); ++e) {
      if (!features[e]) continue;
      for (const Index v : edges.ends[e]) around[start[v + 1]++] = e;
    }
    for (Index v = 0; v < positions.rows(); ++v) {
      const Index count = start[v + 1] - start[v];
      if (count <= kMostEdgesAtVertex) joinAt(v, around.data() + start[v], count);
    }
  }

  /// The run through an edge, if none was told before that it is in.
  Run runThrough(Index edge) {
    Run run;
    if (isSeen_[edge]) return run;
    int side = 0;  // the one to go to: back to where it begins, and then all the way
    Index first = edge;
    while (next_[first][side] >= 0 && !run.isClosed) {
      side = step(first, side);
      run.isClosed = first == edge;
    }
    side = 1 - side;
    run.vertices.push_back(edges_.ends[first][1 - side]);
    for (Index e = first; !isSeen_[e]; side = step(e, side)) {
      isSeen_[e] = true;
      run.vertices.push_back(edges_.ends[e][side]);
      if (next_[e][side] < 0) return run;
    }
    run.vertices.pop_back();
    return run;
  }

 private:
  /// Goes from an edge, at the given side of it, on to the next; returns the far side of that.
  int step(Index& edge, int side) const {
    const Index vertex = edges_.ends[edge][side];
    edge = next_[edge][side];
    return edges_.ends[edge][0] == vertex ? 1 : 0;
  }

  /// Joins edges of a vertex that are each other's only continuation.
  void joinAt(Index vertex, const Index* around, Index count) {
    std::array<Vec3, kMostEdgesAtVertex> out;
    std::array<Index, kMostEdgesAtVertex> partner, partners;
    partners.fill(0);
    for (Index i = 0; i < count; ++i) out[i] = positions_.row(otherEnd(around[i], vertex)) - positions_.row(vertex);
    for (Index i = 0; i < count; ++i) {
      for (Index j = 0; j < count; ++j) {
        if (!bendsLittle(-out[i], out[j], kMostBend)) continue;
        partner[i] = j;
        ++partners[i];
      }
    }
    for (Index i = 0; i < count; ++i) {
      if (partners[i] != 1 || partners[partner[i]] != 1) continue;
      next_[around[i]][edges_.ends[around[i]][0] == vertex ? 0 : 1] = around[partner[i]];
    }
  }

  Index otherEnd(Index edge, Index vertex) const { return edges_.ends[edge][edges_.ends[edge][0] == vertex ? 1 : 0]; }

  const Points& positions_;
  const MeshEdges& edges_;
  std::vector<std::array<Index, 2>> next_;  // #E, the edge that goes on at each end, or −1
  std::vector<bool> isSeen_;                // #E
};

/// Tells of a run what is straight of it.
class StraightParts {
 public:
  explicit StraightParts(const Points& positions) : positions_(positions) {}

  void append(ChainWalk::Run run, VertexChains& chains) const {
    if (run.vertices.size() < kLeastVertices) return;
    if (run.isClosed && !openAtBend(run.vertices)) return;
    if (!run.isClosed && isStraight(run.vertices)) {
      chains.push_back(std::move(run.vertices));
      return;
    }
    for (std::size_t first = 0, last; first + 1 < run.vertices.size(); first = last) {
      last = first + 1;
      while (last + 1 < run.vertices.size() &&
             bendsLittle(between(run.vertices[first], run.vertices[last]),
                         between(run.vertices[last], run.vertices[last + 1]), kMostBendOfPart)) {
        ++last;
      }
      if (last + 1 - first >= kLeastVertices) {
        chains.emplace_back(run.vertices.begin() + first, run.vertices.begin() + last + 1);
      }
    }
  }

 private:
  Vec3 between(Index v, Index w) const { return (positions_.row(w) - positions_.row(v)).transpose(); }

  bool isStraight(const std::vector<Index>& vertices) const {
    const Vec3 chord = between(vertices.front(), vertices.back());
    for (std::size_t i = 0; i + 1 < vertices.size(); ++i) {
      if (!bendsLittle(chord, between(vertices[i], vertices[i + 1]), kMostBend)) return false;
    }
    return true;
  }

  /// Lets a closed run begin and end at a vertex where it bends, so that no straight part goes over the ends; returns
  /// whether there is one.
  bool openAtBend(std::vector<Index>& vertices) const {
    const std::size_t count = vertices.size();
    for (std::size_t i = 0; i < count; ++i) {
      const Index before = vertices[(i + count - 1) % count], v = vertices[i], after = vertices[(i + 1) % count];
      if (bendsLittle(between(before, v), between(v, after), kMostBendOfPart)) continue;
      std::rotate(vertices.begin(), vertices.begin() + static_cast<std::ptrdiff_t>(i), vertices.end());
      vertices.push_back(vertices.front());
      return true;
    }
    return false;
  }

  const Points& positions_;
};

}  // namespace

VertexChains straightChains(const Points& positions, const MeshEdges& edges, const std::vector<bool>& features) {
  ChainWalk walk(positions, edges, features);
  const StraightParts parts(positions);
  VertexChains chains;
  for (Index e = 0; e < edges.count(); ++e) {
    if (features[e]) parts.append(walk.runThrough(e), chains);
  }
  return chains;
}

}  // namespace whittle
