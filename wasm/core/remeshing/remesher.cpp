#include "remeshing/remesher.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "geometry/feature_edges.h"
#include "geometry/surface.h"
#include "mesh/disjoint_sets.h"
#include "remeshing/remeshed_surface.h"

namespace whittle {

namespace {

/// What a slice does at most: boxes moved in the tree, elements that a pass goes over.
constexpr std::size_t kMoved = 200'000;
constexpr Index kElements = 6'000;

/// Share of the mesh's longest side by which an edge may leave its crease.
constexpr double kTolerance = 4e-4;
/// Cosine of the angle between a vertex's normal and a face from which on the vertex is a tip, 50°.
constexpr double kTip = 0.64;
/// Rounds of all steps at the final size, and halvings of edge lengths before at most.
constexpr int kRounds = 5, kMostHalvings = 6;

/// Share of the work that is done when the shape is known.
constexpr double kStudyShare = 0.1;

/// Creases: features, marked ones, and all edges that have not two faces with the same side up.
std::vector<bool> creasesOf(const TriangleMesh& mesh, const MeshEdges& edges, const std::vector<FacePair>& pairs,
                            const RemeshSettings& settings) {
  std::vector<bool> isCrease = featureEdges(pairs, edges.count(), settings.featureAngle * EIGEN_PI / 180);
  const auto mark = [&](const std::vector<std::array<Index, 2>>& marked, bool value) {
    for (auto ends : marked) {
      if (ends[0] > ends[1]) std::swap(ends[0], ends[1]);
      const auto place = std::lower_bound(edges.ends.begin(), edges.ends.end(), ends);
      if (place != edges.ends.end() && *place == ends) isCrease[place - edges.ends.begin()] = value;
    }
  };
  mark(settings.smoothEdges, false);
  mark(settings.creases, true);
  for (Index e = 0; e < edges.count(); ++e) {
    if (edges.faceCountAt(e) != 2) isCrease[e] = true;
  }
  for (const FacePair& pair : pairs) {
    const auto tail = [&](Index h) { return mesh.triangles(faceOf(h), tailCorner(h)); };
    if (tail(pair.first) == tail(pair.second)) isCrease[pair.edge] = true;
  }
  return isCrease;
}

/// Vertices in which faces meet that share no edge there, and tips of cones.
std::vector<bool> cornersOf(const TriangleMesh& mesh, const MeshEdges& edges, const std::vector<FacePair>& pairs,
                            const std::vector<bool>& isCrease) {
  DisjointSets fans(static_cast<Index>(mesh.triangles.size()));
  for (const FacePair& pair : pairs) {
    for (const int one : {tailCorner(pair.first), headCorner(pair.first)}) {
      for (const int other : {tailCorner(pair.second), headCorner(pair.second)}) {
        const Index f = faceOf(pair.first), g = faceOf(pair.second);
        if (mesh.triangles(f, one) == mesh.triangles(g, other)) fans.join(3 * f + one, 3 * g + other);
      }
    }
  }
  std::vector<bool> isCorner(mesh.vertexCount(), false);
  std::vector<Index> fanOf(mesh.vertexCount(), -1);
  const Points normals = faceNormals(mesh.positions, mesh.triangles),
               average = vertexNormals(mesh.positions, mesh.triangles);
  for (Index corner = 0; corner < mesh.triangles.size(); ++corner) {
    const Index v = mesh.triangles.data()[corner], fan = fans.find(corner);
    if (fanOf[v] >= 0 && fanOf[v] != fan) isCorner[v] = true;
    fanOf[v] = fan;
  }
  // On creases normals differ anyway.
  std::vector<bool> isOnCrease(mesh.vertexCount(), false);
  for (Index e = 0; e < edges.count(); ++e) {
    if (!isCrease[e]) continue;
    for (const Index v : edges.ends[e]) isOnCrease[v] = true;
  }
  for (Index corner = 0; corner < mesh.triangles.size(); ++corner) {
    const Index v = mesh.triangles.data()[corner];
    if (!isOnCrease[v] && normals.row(faceOf(corner)).dot(average.row(v)) < kTip) isCorner[v] = true;
  }
  return isCorner;
}

}  // namespace

struct Remesher::Shape {
  MeshEdges edges;
  std::vector<FacePair> pairs;
  std::vector<bool> isCrease;
  std::optional<CreaseLines> lines;
  std::optional<PatchSurface> patches;
  std::optional<RemeshedSurface> surface;
};

Remesher::Remesher(const TriangleMesh& mesh, RemeshSettings settings)
    : mesh_(mesh), settings_(std::move(settings)), shape_(std::make_unique<Shape>()) {}
Remesher::~Remesher() = default;

double Remesher::next() {
  if (!shape_->patches) {
    study();
    return kStudyShare / 4;
  }
  if (!shape_->patches->growNext(kMoved)) return kStudyShare / 2;
  if (!shape_->surface) {
    const double tolerance = kTolerance * boundingBox(mesh_).sizes().maxCoeff();
    shape_->surface.emplace(mesh_, shape_->edges, *shape_->patches, *shape_->lines, tolerance);
    plan();
    return kStudyShare;
  }
  work();
  return pass_ < passes_.size() ? kStudyShare + (1 - kStudyShare) * pass_ / passes_.size() : 1;
}

void Remesher::study() {
  Shape& shape = *shape_;
  if (shape.edges.start.empty()) {
    shape.edges = MeshEdges(mesh_.triangles, mesh_.vertexCount());
  } else if (shape.isCrease.size() != shape.edges.ends.size()) {
    shape.pairs = facePairs(mesh_.positions, mesh_.triangles, shape.edges);
    shape.isCrease = creasesOf(mesh_, shape.edges, shape.pairs, settings_);
  } else if (!shape.lines) {
    shape.lines.emplace(mesh_, shape.edges, shape.isCrease, cornersOf(mesh_, shape.edges, shape.pairs, shape.isCrease));
  } else {
    shape.patches.emplace(mesh_, shape.edges, shape.pairs, shape.isCrease, settings_.edge);
  }
}

void Remesher::plan() {
  using Kind = Pass::Kind;
  double longest = 0;
  for (const auto& [a, b] : shape_->edges.ends) {
    longest = std::max(longest, (mesh_.positions.row(a) - mesh_.positions.row(b)).norm());
  }
  const int halvings = std::clamp(static_cast<int>(std::ceil(std::log2(longest / settings_.edge))), 0, kMostHalvings);
  const auto add = [&](std::initializer_list<Kind> kinds, double scale) {
    for (const Kind kind : kinds) passes_.push_back({kind, scale});
  };
  // From coarse to fine, so that long slivers are flipped into shape before they are cut small.
  for (int level = halvings; level > 0; --level) {
    const double scale = std::pow(2.0, level);
    add({Kind::flip, Kind::collapse, Kind::flip, Kind::split, Kind::flip, Kind::flip}, scale);
  }
  for (int round = 0; round < kRounds; ++round) {
    add({Kind::measure, Kind::grade, Kind::grade, Kind::grade, Kind::split, Kind::split, Kind::collapse, Kind::flip,
         Kind::flip, Kind::smooth, Kind::flip, Kind::smooth},
        1);
  }
  add({Kind::split, Kind::flip, Kind::smooth, Kind::flip}, 1);
  end_ = passes_.empty() ? 0 : count(passes_.front());
}

Index Remesher::count(const Pass& pass) const {
  using Kind = Pass::Kind;
  const bool isOfFaces = pass.kind == Kind::split || pass.kind == Kind::collapse || pass.kind == Kind::flip;
  return isOfFaces ? shape_->surface->mesh().faceCount() : shape_->surface->mesh().vertexCount();
}

void Remesher::apply(const Pass& pass, Index element) {
  RemeshedSurface& surface = *shape_->surface;
  using Kind = Pass::Kind;
  const auto isFace = [&] { return surface.mesh().isFace(element); };
  switch (pass.kind) {
    case Kind::measure: surface.measure(element); break;
    case Kind::grade: surface.grade(element); break;
    case Kind::smooth: surface.smooth(element); break;
    case Kind::split:
      if (isFace()) surface.split(element, pass.scale);
      break;
    case Kind::collapse:
      while (isFace() && surface.collapse(element, pass.scale)) {
      }
      break;
    case Kind::flip:
      if (isFace()) surface.flip(element);
      break;
  }
}

void Remesher::work() {
  const Index last = std::min(end_, next_ + kElements);
  for (; next_ < last; ++next_) apply(passes_[pass_], next_);
  if (next_ < end_) return;
  next_ = 0;
  if (++pass_ < passes_.size()) end_ = count(passes_[pass_]);
}

CleanMesh Remesher::take() {
  const DerivedMesh made = shape_->surface->mesh().derived();
  shape_.reset();
  CleanMesh result = clean(made.mesh);
  result.derived = made.then(std::move(result.derived));
  return result;
}

}  // namespace whittle
