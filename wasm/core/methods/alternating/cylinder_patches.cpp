#include "methods/alternating/cylinder_patches.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "mesh/disjoint_sets.h"

namespace whittle {

namespace {

constexpr double kLeastAnisotropy = 0.5, kLeastCurvature = 1;
constexpr std::size_t kLeastFaces = 8;
constexpr double kMostTilt = 0.1;  // root mean square of normal · axis
constexpr double kMostDeviation = 0.03, kShareWithin = 0.95;
/// Vertices whose spread across a line is below this share of that along it (squared) show no circle.
constexpr double kNoArc = 1e-10;

constexpr double kMostDifference = 1e-3;  // of handles' moves
constexpr double kSameDirection = 2 * EIGEN_PI / 180, kSameAxis = 0.05;
constexpr double kLeastRatio = 0.7, kMostRatio = 1.43;

/// Faces that may lie on cylinders, each piece of them in one list.
std::vector<std::vector<Index>> roundPieces(const std::vector<FacePair>& pairs, const std::vector<bool>& features,
                                            const Curvatures& curvatures) {
  const Index faceCount = static_cast<Index>(curvatures.larger.size());
  const auto isRound = [&](Index f) {
    return curvatures.anisotropy(f) > kLeastAnisotropy && curvatures.strongest(f) > kLeastCurvature &&
           !curvatures.direction.row(f).isZero(0);
  };
  DisjointSets sets(faceCount);
  for (const FacePair& pair : pairs) {
    const Index f = faceOf(pair.first), g = faceOf(pair.second);
    if (!features[pair.edge] && isRound(f) && isRound(g)) sets.join(f, g);
  }
  std::vector<Index> pieceOf(faceCount, -1);
  std::vector<std::vector<Index>> pieces;
  for (Index f = 0; f < faceCount; ++f) {
    if (!isRound(f)) continue;
    Index& piece = pieceOf[sets.find(f)];
    if (piece < 0) {
      piece = static_cast<Index>(pieces.size());
      pieces.emplace_back();
    }
    pieces[piece].push_back(f);
  }
  return pieces;
}

/// Holds pieces of one mesh against cylinders.
class CylinderFit {
 public:
  CylinderFit(const TriangleMesh& mesh, const Curvatures& curvatures)
      : mesh_(mesh), curvatures_(curvatures), seenIn_(mesh.vertexCount(), -1) {}

  /// Fits a cylinder to the faces of a patch; returns whether it is one.
  bool operator()(CylinderPatch& patch) { return findAxis(patch) && findCircle(patch); }

 private:
  bool findAxis(CylinderPatch& patch) const {
    Mat3 axes = Mat3::Zero(), normals = Mat3::Zero();
    double area = 0;
    for (const Index f : patch.faces) {
      const Vec3 a = at(f, 0), vector = (at(f, 1) - a).cross(at(f, 2) - a), normal = vector.stableNormalized();
      const double weight = vector.norm();
      const Vec3 along = normal.cross(curvatures_.direction.row(f).transpose());
      axes += weight * along * along.transpose();
      normals += weight * normal * normal.transpose();
      area += weight;
    }
    patch.axis = Eigen::SelfAdjointEigenSolver<Mat3>(axes).eigenvectors().col(2);
    return patch.axis.dot(normals * patch.axis) <= kMostTilt * kMostTilt * area;
  }

  /// Finds the circle around the axis that minimizes Σ (|p − c|² − r²)² over the vertices.
  bool findCircle(CylinderPatch& patch) {
    const Vec3 u = patch.axis.unitOrthogonal(), v = patch.axis.cross(u);
    const Vec3 middle = collectVertices(patch);
    Eigen::Matrix2d spread = Eigen::Matrix2d::Zero();
    Eigen::Vector2d moment = Eigen::Vector2d::Zero();
    double squares = 0;
    for (Vec3& offset : offsets_) {
      offset = Vec3(offset.dot(u), offset.dot(v), 0);
      const Eigen::Vector2d p = offset.head<2>();
      spread += p * p.transpose();
      moment += p.squaredNorm() / 2 * p;
      squares += p.squaredNorm();
    }
    const double count = static_cast<double>(offsets_.size());
    if (!(spread.determinant() > kNoArc * spread.trace() * spread.trace())) return false;
    const Eigen::Vector2d center = spread.inverse() * moment;
    patch.point = middle + center[0] * u + center[1] * v;
    patch.radius = std::sqrt(squares / count + center.squaredNorm());
    deviations_.clear();
    for (const Vec3& offset : offsets_) {
      deviations_.push_back(std::abs((offset.head<2>() - center).norm() - patch.radius));
    }
    const auto within = deviations_.begin() + (static_cast<std::ptrdiff_t>(std::ceil(kShareWithin * count)) - 1);
    std::nth_element(deviations_.begin(), within, deviations_.end());
    return *within <= kMostDeviation * patch.radius;
  }

  /// Puts the patch's vertices, as offsets from their mean, into `offsets_`; returns the mean.
  Vec3 collectVertices(const CylinderPatch& patch) {
    offsets_.clear();
    Vec3 sum = Vec3::Zero();
    for (const Index f : patch.faces) {
      for (int k = 0; k < 3; ++k) {
        Index& seenIn = seenIn_[mesh_.triangles(f, k)];
        if (seenIn == patch.faces[0]) continue;
        seenIn = patch.faces[0];
        offsets_.push_back(at(f, k));
        sum += offsets_.back();
      }
    }
    const Vec3 mean = sum / static_cast<double>(offsets_.size());
    for (Vec3& offset : offsets_) offset -= mean;
    return mean;
  }

  Vec3 at(Index f, int k) const { return mesh_.positions.row(mesh_.triangles(f, k)).transpose(); }

  const TriangleMesh& mesh_;
  const Curvatures& curvatures_;
  std::vector<Index> seenIn_;  // #V, first face of the patch that a vertex was in last
  std::vector<Vec3> offsets_;
  std::vector<double> deviations_;
};

/// How far apart displacements get across an axis: widths in eight directions, which find 98 % of it.
class SpreadAcross {
 public:
  explicit SpreadAcross(const Vec3& axis) : u_(axis.unitOrthogonal()), v_(axis.cross(u_)) {
    least_.fill(std::numeric_limits<double>::infinity());
    most_.fill(-std::numeric_limits<double>::infinity());
  }

  void add(const Vec3& displacement) {
    const double x = displacement.dot(u_), y = displacement.dot(v_);
    for (int i = 0; i < kDirections; ++i) {
      const double angle = EIGEN_PI * i / kDirections, along = std::cos(angle) * x + std::sin(angle) * y;
      least_[i] = std::min(least_[i], along);
      most_[i] = std::max(most_[i], along);
    }
  }

  double width() const {
    double widest = 0;
    for (int i = 0; i < kDirections; ++i) widest = std::max(widest, most_[i] - least_[i]);
    return widest;
  }

 private:
  static constexpr int kDirections = 8;
  Vec3 u_, v_;
  std::array<double, kDirections> least_, most_;
};

bool areOneWall(const CylinderPatch& a, const CylinderPatch& b) {
  const double ratio = a.radius / b.radius;
  if (ratio < kLeastRatio || ratio > kMostRatio) return false;
  if (a.axis.cross(b.axis).norm() > std::sin(kSameDirection)) return false;
  const Vec3 between = b.point - a.point;
  const double apart = std::min(between.cross(a.axis).norm(), between.cross(b.axis).norm());
  return apart <= kSameAxis * std::max(a.radius, b.radius);
}

}  // namespace

std::vector<CylinderPatch> cylinderPatches(const TriangleMesh& mesh, const std::vector<FacePair>& pairs,
                                           const std::vector<bool>& features, const Curvatures& curvatures) {
  std::vector<CylinderPatch> patches;
  CylinderFit fit(mesh, curvatures);
  for (std::vector<Index>& faces : roundPieces(pairs, features, curvatures)) {
    if (faces.size() < kLeastFaces) continue;
    CylinderPatch patch{std::move(faces), Vec3::Zero(), Vec3::Zero(), 0};
    if (fit(patch)) patches.push_back(std::move(patch));
  }
  return patches;
}

std::vector<bool> keptPatches(const std::vector<CylinderPatch>& patches, const TriangleMesh& mesh,
                              const Handles& handles) {
  std::vector<Index> handleOf(mesh.vertexCount(), -1);
  for (std::size_t i = 0; i < handles.vertices.size(); ++i) handleOf[handles.vertices[i]] = static_cast<Index>(i);
  std::vector<bool> kept(patches.size(), true);
  std::vector<std::size_t> leftOut;  // whose walls are still to be looked for from `next` on
  for (std::size_t i = 0; i < patches.size(); ++i) {
    SpreadAcross spread(patches[i].axis);
    for (const Index f : patches[i].faces) {
      for (int k = 0; k < 3; ++k) {
        const Index v = mesh.triangles(f, k), handle = handleOf[v];
        if (handle >= 0) spread.add((handles.targets.row(handle) - mesh.positions.row(v)).transpose());
      }
    }
    if (spread.width() <= kMostDifference) continue;
    kept[i] = false;
    leftOut.push_back(i);
  }
  for (std::size_t next = 0; next < leftOut.size(); ++next) {
    for (std::size_t i = 0; i < patches.size(); ++i) {
      if (!kept[i] || !areOneWall(patches[leftOut[next]], patches[i])) continue;
      kept[i] = false;
      leftOut.push_back(i);
    }
  }
  return kept;
}

}  // namespace whittle
