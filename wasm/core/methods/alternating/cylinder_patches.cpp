#include "methods/alternating/cylinder_patches.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "mesh/disjoint_sets.h"
#include "methods/alternating/flat_regions.h"

namespace whittle {

namespace {

constexpr double kLeastAnisotropy = 0.5, kLeastCurvature = 1;
constexpr std::size_t kLeastFaces = 8;
constexpr double kMostTilt = 0.1;  // root mean square of normal · axis
constexpr double kMostDeviation = 0.03;
constexpr double kLeastShare = 0.25;                                   // of a piece's faces that a cylinder in it has
const double kMostUnited = std::sin(EIGEN_PI / 12) / (EIGEN_PI / 12);  // mean normal of an arc of 30°
const double kLeastRadial = std::cos(EIGEN_PI / 9);  // of normals, as remeshed holes of 10 edges have them
const double kSameTurn = std::cos(EIGEN_PI / 9);  // of axes, by curvature, of faces beside each other, and by normals
const double kWidestFacet = 2 * std::sin(EIGEN_PI / 9);  // of the radius: what bends more than 40° has creases
const double kFlat = std::cos(EIGEN_PI / 90);            // of normals in a region that is flat, not just finely meshed
/// Vertices whose spread across a line is below this share of that along it (squared) show no circle.
constexpr double kNoArc = 1e-10;

constexpr double kMostDifference = 1e-3;  // of handles' moves
constexpr double kSameDirection = 2 * EIGEN_PI / 180, kSameAxis = 0.05;
constexpr double kLeastRatio = 0.7, kMostRatio = 1.43;

/// Unit normals and the directions in which faces do not curve, or hardly, #F×3: the axis of a cylinder.
struct FaceFrames {
  Points normals, axes;

  FaceFrames(const TriangleMesh& mesh, const Curvatures& curvatures)
      : normals(mesh.faceCount(), 3), axes(mesh.faceCount(), 3) {
    const auto at = [&](Index f, int k) -> Vec3 { return mesh.positions.row(mesh.triangles(f, k)).transpose(); };
    for (Index f = 0; f < mesh.faceCount(); ++f) {
      const Vec3 a = at(f, 0), normal = (at(f, 1) - a).cross(at(f, 2) - a).stableNormalized();
      normals.row(f) = normal.transpose();
      axes.row(f) = normal.cross(curvatures.direction.row(f).transpose()).transpose();
    }
  }
};

/// Faces that may lie on cylinders, each piece of them in one list.
std::vector<std::vector<Index>> roundPieces(const std::vector<FacePair>& pairs, const std::vector<bool>& features,
                                            const Curvatures& curvatures, const Points& axes) {
  const Index faceCount = static_cast<Index>(curvatures.larger.size());
  const auto isRound = [&](Index f) {
    return curvatures.anisotropy(f) > kLeastAnisotropy && curvatures.strongest(f) > kLeastCurvature &&
           !curvatures.direction.row(f).isZero(0);
  };
  const auto turnAlike = [&](Index f, Index g) { return std::abs(axes.row(f).dot(axes.row(g))) > kSameTurn; };
  DisjointSets sets(faceCount);
  for (const FacePair& pair : pairs) {
    const Index f = faceOf(pair.first), g = faceOf(pair.second);
    if (!features[pair.edge] && isRound(f) && isRound(g) && turnAlike(f, g)) sets.join(f, g);
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
  CylinderFit(const TriangleMesh& mesh, const Curvatures& curvatures, const FaceFrames& frames,
              const FlatRegions& regions)
      : mesh_(mesh), curvatures_(curvatures), frames_(frames), regions_(regions), seenIn_(mesh.vertexCount(), -1),
        offCircle_(mesh.vertexCount()), widthOf_(regions.faces.size()) {}

  /// Fits a cylinder to the faces of a patch; returns whether it is one. Faces that are off it are dropped, as are flat
  /// ones beside a fillet, whose curvature is estimated from both, and it is tried again.
  bool operator()(CylinderPatch& patch) {
    const std::size_t whole = patch.faces.size();
    const std::size_t least = std::max(kLeastFaces, static_cast<std::size_t>(kLeastShare * whole));
    while (patch.faces.size() >= least) {
      if (!findAxis(patch)) {
        if (std::erase_if(patch.faces, [&](Index f) { return isAskew(patch, f); }) == 0) return false;
        continue;
      }
      if (!findCircle(patch)) return false;
      // Flat faces go first, as the circle says little of the others while they are in it.
      measureRegions(patch);
      if (std::erase_if(patch.faces, [&](Index f) { return isOfWideRegion(patch, f); }) > 0) continue;
      if (std::erase_if(patch.faces, [&](Index f) { return !isRadial(patch, f) || isOffCircle(patch, f); }) == 0)
        return isBent(patch);
    }
    return false;
  }

 private:
  bool findAxis(CylinderPatch& patch) const {
    Mat3 axes = Mat3::Zero(), normals = Mat3::Zero();
    double area = 0;
    for (const Index f : patch.faces) {
      const Vec3 normal = frames_.normals.row(f).transpose(), along = frames_.axes.row(f).transpose();
      const Vec3 a = at(f, 0);
      const double weight = (at(f, 1) - a).cross(at(f, 2) - a).norm();
      axes += weight * along * along.transpose();
      normals += weight * normal * normal.transpose();
      area += weight;
    }
    patch.axis = Eigen::SelfAdjointEigenSolver<Mat3>(axes).eigenvectors().col(2);
    // Normals tell the axis exactly, but of an arc that is nearly flat only where curvature says what to look for.
    const Vec3 flattest = Eigen::SelfAdjointEigenSolver<Mat3>(normals).eigenvectors().col(0);
    if (std::abs(flattest.dot(patch.axis)) > kSameTurn) patch.axis = flattest;
    return patch.axis.dot(normals * patch.axis) <= kMostTilt * kMostTilt * area;
  }

  /// Whether the normals go over 30° or more and the radius is that of the curvature, within a factor of 2: anything
  /// smooth has pieces that fit a cylinder otherwise.
  bool isBent(const CylinderPatch& patch) const {
    Vec3 sum = Vec3::Zero();
    double curvature = 0;
    for (const Index f : patch.faces) {
      sum += frames_.normals.row(f).transpose();
      curvature += curvatures_.strongest(f);
    }
    const double count = static_cast<double>(patch.faces.size()), turns = curvature / count * patch.radius;
    return sum.norm() <= kMostUnited * count && turns > 0.5 && turns < 2;
  }

  bool isAskew(const CylinderPatch& patch, Index f) const {
    return std::abs(frames_.normals.row(f).dot(patch.axis)) > kMostTilt;
  }

  /// Whether a face looks to the axis or away from it, within 20°.
  bool isRadial(const CylinderPatch& patch, Index f) const {
    const Vec3 offset = (at(f, 0) + at(f, 1) + at(f, 2)) / 3 - patch.point;
    const Vec3 radial = offset - offset.dot(patch.axis) * patch.axis;
    return std::abs(frames_.normals.row(f).dot(radial)) >= kLeastRadial * radial.norm();
  }

  bool isOfWideRegion(const CylinderPatch& patch, Index f) const {
    return widthOf_[regions_.of[f]] > kWidestFacet * patch.radius;
  }

  bool isOffCircle(const CylinderPatch& patch, Index f) const {
    for (int k = 0; k < 3; ++k) {
      if (offCircle_[mesh_.triangles(f, k)] > kMostDeviation * patch.radius) return true;
    }
    return false;
  }

  /// Finds how wide the flat regions of a patch are across its axis, beyond the patch as well: those beside a fillet are
  /// wider than any facet of it. What is not flat counts as narrow.
  void measureRegions(const CylinderPatch& patch) {
    for (const Index f : patch.faces) widthOf_[regions_.of[f]] = -1;
    for (const Index f : patch.faces) {
      double& width = widthOf_[regions_.of[f]];
      if (width >= 0) continue;
      const Vec3 normal = frames_.normals.row(f).transpose(), across = patch.axis.cross(normal);
      double low = std::numeric_limits<double>::infinity(), high = -low;
      bool isFlat = true;
      for (const Index g : regions_.faces[regions_.of[f]]) {
        isFlat = isFlat && frames_.normals.row(g).dot(normal.transpose()) > kFlat;
        for (int k = 0; k < 3; ++k) {
          low = std::min(low, at(g, k).dot(across));
          high = std::max(high, at(g, k).dot(across));
        }
      }
      width = isFlat ? high - low : 0;
    }
  }

  /// Finds the circle around the axis that minimizes Σ (|p − c|² − r²)² over the vertices, and how far they are off it;
  /// false where they are on a line.
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
    for (std::size_t i = 0; i < offsets_.size(); ++i) {
      offCircle_[vertices_[i]] = std::abs((offsets_[i].head<2>() - center).norm() - patch.radius);
    }
    return true;
  }

  /// Puts the patch's vertices, as offsets from their mean, into `offsets_`; returns the mean.
  Vec3 collectVertices(const CylinderPatch& patch) {
    offsets_.clear();
    vertices_.clear();
    ++fits_;
    Vec3 sum = Vec3::Zero();
    for (const Index f : patch.faces) {
      for (int k = 0; k < 3; ++k) {
        Index& seenIn = seenIn_[mesh_.triangles(f, k)];
        if (seenIn == fits_) continue;
        seenIn = fits_;
        vertices_.push_back(mesh_.triangles(f, k));
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
  const FaceFrames& frames_;
  const FlatRegions& regions_;
  Index fits_ = 0;
  std::vector<Index> seenIn_;  // #V, the fit that a vertex was in last
  std::vector<Index> vertices_;
  std::vector<Vec3> offsets_;
  Scalars offCircle_;            // #V, deviation in the last fit
  std::vector<double> widthOf_;  // by region, of those in the patch
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
  const FaceFrames frames(mesh, curvatures);
  const FlatRegions regions(mesh.faceCount(), pairs);
  CylinderFit fit(mesh, curvatures, frames, regions);
  for (std::vector<Index>& faces : roundPieces(pairs, features, curvatures, frames.axes)) {
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
