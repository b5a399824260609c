#include "mesh/significant_vertices.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "mesh/bounding_box.h"

namespace whittle {

namespace {

constexpr double kFarGap = 100;
constexpr Index kBins = 1 << 16;

/// Some faces of a mesh, and the box around them.
struct Faces {
  const TriangleMesh& mesh;
  std::vector<Index> list;
  Box box;

  Vec3 corner(Index face, int k) const { return mesh.positions.row(mesh.triangles(face, k)).transpose(); }
  double binSize(int axis) const { return box.sizes()[axis] / kBins; }
  Index binOf(double x, int axis) const {
    return std::min(kBins - 1, static_cast<Index>((x - box.min()[axis]) / binSize(axis)));
  }
  void findBox() {
    box.setEmpty();
    for (const Index f : list) {
      for (int k = 0; k < 3; ++k) box.extend(corner(f, k));
    }
  }
};

/// Whether one of a few thousand faces, or all of these, cover so much of the longest axis that no gap can be far.
bool isWellCovered(const Faces& faces) {
  int longest = 0;
  faces.box.sizes().maxCoeff(&longest);
  if (!(faces.binSize(longest) > 0)) return true;
  std::vector<bool> isCovered(kBins, false);
  const std::size_t stride = (faces.list.size() + 8191) / 8192;
  double count = 0;
  for (std::size_t i = 0; i < faces.list.size(); i += stride) {
    const double a = faces.corner(faces.list[i], 0)[longest], b = faces.corner(faces.list[i], 1)[longest];
    if (kFarGap * std::abs(b - a) > faces.box.sizes()[longest]) return true;
    const Index bin = faces.binOf(a, longest);
    if (isCovered[bin]) continue;
    isCovered[bin] = true;
    if (kFarGap * ++count > kBins) return true;
  }
  return false;
}

/// How many faces lie over each bin of an axis.
std::vector<Index> coverOf(const Faces& faces, int axis) {
  std::vector<Index> cover(kBins + 1, 0);
  for (const Index f : faces.list) {
    const auto [low, high] =
        std::minmax({faces.corner(f, 0)[axis], faces.corner(f, 1)[axis], faces.corner(f, 2)[axis]});
    ++cover[faces.binOf(low, axis)];
    --cover[faces.binOf(high, axis) + 1];
  }
  std::partial_sum(cover.begin(), cover.end(), cover.begin());
  return cover;
}

/// The piece in which each bin lies, from 0 on, cut where more than `far` bins are empty.
std::vector<Index> piecesOfBins(const std::vector<Index>& cover, double far) {
  std::vector<Index> pieces(kBins);
  Index empty = 0, count = 0;
  for (Index bin = 0; bin < kBins; ++bin) {
    if (cover[bin] > 0 && empty > far) ++count;
    empty = cover[bin] > 0 ? 0 : empty + 1;
    pieces[bin] = count;
  }
  return pieces;
}

/// Keeps the faces of the piece with the largest surface.
void keepLargest(Faces& faces, int axis, const std::vector<Index>& pieceOfBin) {
  const auto pieceOf = [&](Index f) { return pieceOfBin[faces.binOf(faces.corner(f, 0)[axis], axis)]; };
  std::vector<double> areas(pieceOfBin.back() + 1, 0);
  for (const Index f : faces.list) {
    const Vec3 a = faces.corner(f, 0);
    areas[pieceOf(f)] += (faces.corner(f, 1) - a).cross(faces.corner(f, 2) - a).norm();
  }
  const Index largest = static_cast<Index>(std::max_element(areas.begin(), areas.end()) - areas.begin());
  std::erase_if(faces.list, [&](Index f) { return pieceOf(f) != largest; });
  faces.findBox();
}

/// Cuts along the first axis that has a far gap; false where none has.
bool cutStrays(Faces& faces) {
  if (isWellCovered(faces)) return false;
  std::array<std::vector<Index>, 3> covers;
  double covered = 0;
  for (int axis = 0; axis < 3; ++axis) {
    if (!(faces.binSize(axis) > 0)) continue;
    covers[axis] = coverOf(faces, axis);
    const auto count = std::count_if(covers[axis].begin(), covers[axis].end() - 1, [](Index n) { return n > 0; });
    covered = std::max(covered, faces.binSize(axis) * static_cast<double>(count));
  }
  for (int axis = 0; axis < 3; ++axis) {
    if (covers[axis].empty()) continue;
    const std::vector<Index> pieces = piecesOfBins(covers[axis], kFarGap * covered / faces.binSize(axis));
    if (pieces.back() == 0) continue;
    keepLargest(faces, axis, pieces);
    return true;
  }
  return false;
}

}  // namespace

std::vector<Index> significantVertices(const TriangleMesh& mesh) {
  Faces faces{mesh, std::vector<Index>(mesh.faceCount()), {}};
  std::iota(faces.list.begin(), faces.list.end(), 0);
  faces.findBox();
  while (cutStrays(faces)) {
  }
  std::vector<bool> isKept(mesh.vertexCount(), false);
  for (const Index f : faces.list) {
    for (int k = 0; k < 3; ++k) isKept[mesh.triangles(f, k)] = true;
  }
  std::vector<Index> vertices;
  for (Index v = 0; v < mesh.vertexCount(); ++v) {
    if (isKept[v]) vertices.push_back(v);
  }
  return vertices;
}

}  // namespace whittle
