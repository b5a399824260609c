#include "remeshing/transfer.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "geometry/surface.h"
#include "geometry/triangle_contact.h"

namespace whittle {

namespace {

/// What a slice does at most: boxes moved in the tree, vertices placed.
constexpr std::size_t kMoved = 200'000;
constexpr Index kPlaced = 4'000;

/// A face that looks another way or belongs to another part is followed only where all others are farther away by more
/// than this share of the mesh's longest side.
constexpr double kStray = 0.05;
/// Cosine of the angle up to which a face looks the way of another: half a right angle and what remeshing may turn.
constexpr double kSameWay = 0.5;

/// Share of the work that is done when the tree stands.
constexpr double kTreeShare = 0.2;

}  // namespace

Transfer::Transfer(const TriangleMesh& input, const DerivedMesh& working)
    : input_(input), working_(working), fans_(input.triangles, input.vertexCount()), places_(input.vertexCount()) {}

double Transfer::next() {
  if (!tree_) {
    findTwins();
    growTree();
    return kTreeShare / 2;
  }
  if (!tree_->buildNext(kMoved)) return kTreeShare / 2;
  const Index count = input_.vertexCount(), end = std::min(count, next_ + kPlaced);
  for (; next_ < end; ++next_) findPlace(next_);
  return next_ < count ? kTreeShare + (1 - kTreeShare) * next_ / count : 1;
}

void Transfer::findTwins() {
  const TriangleMesh& mesh = working_.mesh;
  for (Index w = 0; w < mesh.vertexCount(); ++w) {
    const Index v = working_.vertexOrigin[w];
    if (v >= 0 && mesh.positions.row(w) == input_.positions.row(v)) places_[v].twin = w;
  }
}

void Transfer::growTree() {
  const TriangleMesh& mesh = working_.mesh;
  inputNormals_ = faceNormals(input_.positions, input_.triangles);
  workingNormals_ = faceNormals(mesh.positions, mesh.triangles);
  partOfVertex_ = connectedComponents(input_.triangles, input_.vertexCount()).ofVertex;
  partOfFace_.resize(mesh.faceCount());
  std::vector<Box> boxes(mesh.faceCount());
  for (Index f = 0; f < mesh.faceCount(); ++f) {
    partOfFace_[f] = partOfVertex_[input_.triangles(working_.faceOrigin[f], 0)];
    for (int k = 0; k < 3; ++k) boxes[f].extend(mesh.positions.row(mesh.triangles(f, k)).transpose());
  }
  const double side = kStray * boundingBox(mesh).sizes().maxCoeff();
  stray_ = side * side;
  tree_.emplace(std::move(boxes));
}

bool Transfer::agrees(Index vertex, Index face) const {
  const auto normal = workingNormals_.row(face);
  if (normal.isZero(0)) return false;
  bool isTurned = false;
  for (Index p = fans_.start[vertex]; p < fans_.start[vertex + 1]; ++p) {
    const auto own = inputNormals_.row(fans_.corners[p] / 3);
    if (own.dot(normal) > kSameWay) return true;
    isTurned = isTurned || !own.isZero(0);
  }
  return !isTurned;  // faces without area look any way
}

void Transfer::findPlace(Index vertex) {
  Place& place = places_[vertex];
  if (place.twin >= 0 || fans_.start[vertex] == fans_.start[vertex + 1]) return;
  const TriangleMesh& mesh = working_.mesh;
  const Vec3 point = input_.positions.row(vertex).transpose();
  double best = std::numeric_limits<double>::infinity();
  tree_->findNear(point, best, [&](Index face) {
    Vec3 corners[3];
    for (int k = 0; k < 3; ++k) corners[k] = mesh.positions.row(mesh.triangles(face, k)).transpose();
    const Vec3 weights = nearestPoint(point, corners[0], corners[1], corners[2]);
    double cost = (weights[0] * corners[0] + weights[1] * corners[1] + weights[2] * corners[2] - point).squaredNorm();
    if (cost >= best) return best;
    if (partOfFace_[face] != partOfVertex_[vertex]) cost += 2 * stray_;
    if (cost >= best) return best;
    if (!agrees(vertex, face)) cost += stray_;
    if (cost >= best) return best;
    place.face = face;
    place.weights = weights;
    return best = cost;
  });
}

void Transfer::carry(const Points& working, Points& input) const {
  const TriangleMesh& mesh = working_.mesh;
  for (Index v = 0; v < input_.vertexCount(); ++v) {
    const Place& place = places_[v];
    input.row(v) = place.twin >= 0 ? working.row(place.twin) : input_.positions.row(v);
    if (place.face < 0) continue;
    Eigen::RowVector3d move = Eigen::RowVector3d::Zero();
    for (int k = 0; k < 3; ++k) {
      const Index corner = mesh.triangles(place.face, k);
      move += place.weights[k] * (working.row(corner) - mesh.positions.row(corner));
    }
    if (!move.isZero(0)) input.row(v) += move;  // adding nothing would turn −0 into 0
  }
}

}  // namespace whittle
