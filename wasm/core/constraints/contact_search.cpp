#include "constraints/contact_search.h"

#include <algorithm>
#include <tuple>
#include <utility>

#include "geometry/triangle_contact.h"

namespace whittle {

namespace {

/// What a slice does at most: faces that are looked at, or moved in a tree.
constexpr Index kSifted = 100'000, kCompared = 10'000;
constexpr std::size_t kMoved = 200'000;

/// Edges from this length on may cross others far from any vertex.
constexpr double kLong = 8 * kContactReach;

/// Shares of the work that are done when a stage begins.
constexpr double kSiftedShare = 0.1, kTreeShare = 0.4;

}  // namespace

ContactSearch::ContactSearch(const TriangleMesh& mesh, std::vector<Index> partOfFace)
    : mesh_(mesh), partOfFace_(std::move(partOfFace)) {
  Index f = 0;
  while (f < mesh.faceCount() && partOf(f) == partOf(0)) ++f;
  if (f == mesh.faceCount()) stage_ = Stage::done;  // one part touches nothing
}

double ContactSearch::next() {
  const auto shareOf = [&](std::size_t count) { return static_cast<double>(next_) / static_cast<double>(count); };
  switch (stage_) {
    case Stage::parts:
      growPartTree();
      stage_ = Stage::sifting;
      return kSiftedShare / 2;
    case Stage::sifting: {
      const Index end = std::min(mesh_.faceCount(), next_ + kSifted);
      for (; next_ < end; ++next_) sift(next_);
      if (next_ < mesh_.faceCount()) return kSiftedShare + (kTreeShare - kSiftedShare) * shareOf(mesh_.faceCount());
      faceTree_.emplace(std::move(boxes_));
      isSeen_.assign(mesh_.vertexCount(), false);
      next_ = 0;
      stage_ = Stage::tree;
      return kTreeShare;
    }
    case Stage::tree:
      if (faceTree_->buildNext(kMoved)) stage_ = Stage::comparing;
      return kTreeShare;
    case Stage::comparing: {
      const Index count = static_cast<Index>(faces_.size()), end = std::min(count, next_ + kCompared);
      for (; next_ < end; ++next_) compare(faces_[next_]);
      if (next_ < count) return kTreeShare + (1 - kTreeShare) * shareOf(faces_.size());
      stage_ = Stage::done;
      return 1;
    }
    case Stage::done: break;
  }
  return 1;
}

void ContactSearch::growPartTree() {
  std::vector<Index> boxOfPart(1 + *std::max_element(partOfFace_.begin(), partOfFace_.end()), -1);
  std::vector<Box> boxes;
  for (Index f = 0; f < mesh_.faceCount(); ++f) {
    Index& box = boxOfPart[partOf(f)];
    if (box < 0) {
      box = static_cast<Index>(boxes.size());
      boxes.emplace_back();
      partOfBox_.push_back(partOf(f));
    }
    for (int k = 0; k < 3; ++k) boxes[box].extend(corner(f, k));
  }
  partTree_.emplace(std::move(boxes));
  while (!partTree_->buildNext(kMoved)) {
  }
}

Box ContactSearch::boxWithReach(Index face) const {
  Box box;
  for (int k = 0; k < 3; ++k) box.extend(corner(face, k));
  const Vec3 reach = Vec3::Constant(kContactReach);
  return {box.min() - reach, box.max() + reach};
}

void ContactSearch::sift(Index face) {
  const Box box = boxWithReach(face);
  if (!partTree_->findIn(box, [&](Index other) { return partOfBox_[other] != partOf(face); })) return;
  faces_.push_back(face);
  boxes_.push_back(box);
}

void ContactSearch::compare(Index face) {
  near_.clear();
  // Boxes have their reach already: two that meet may be twice as far apart, which costs little.
  faceTree_->findIn(boxWithReach(face), [&](Index place) {
    if (partOf(faces_[place]) != partOf(face)) near_.push_back(faces_[place]);
    return false;
  });
  if (near_.empty()) return;
  std::sort(near_.begin(), near_.end(),
            [&](Index a, Index b) { return std::tuple(partOf(a), a) < std::tuple(partOf(b), b); });
  for (int k = 0; k < 3; ++k) {
    const Index v = mesh_.triangles(face, k), w = mesh_.triangles(face, (k + 1) % 3);
    if (!isSeen_[v]) attachVertex(v);
    isSeen_[v] = true;
    attachEdge(std::min(v, w), std::max(v, w));
  }
}

void ContactSearch::attachVertex(Index v) {
  for (std::size_t i = 0; i < near_.size();) {
    const Index part = partOf(near_[i]);
    double least = kContactReach;
    Attachment best{};
    bool isNear = false;
    for (; i < near_.size() && partOf(near_[i]) == part; ++i) {
      const Vec3 a = corner(near_[i], 0), b = corner(near_[i], 1), c = corner(near_[i], 2);
      const Vec3 weights = nearestPoint(at(v), a, b, c);
      const double distance = (at(v) - weights[0] * a - weights[1] * b - weights[2] * c).norm();
      if (distance >= least) continue;
      least = distance;
      isNear = true;
      const auto corners = mesh_.triangles.row(near_[i]);
      best = {{v, v, corners[0], corners[1], corners[2]}, {1, 0, -weights[0], -weights[1], -weights[2]}};
    }
    if (isNear) rows_.push_back(best);
  }
}

void ContactSearch::attachEdge(Index v, Index w) {
  const bool isLong = (at(w) - at(v)).norm() > kLong;
  for (const Index face : near_) {
    if (isLong) attachCrossed(v, w, face);
    const auto found = crossing(at(v), at(w), corner(face, 0), corner(face, 1), corner(face, 2));
    if (!found) continue;
    const auto corners = mesh_.triangles.row(face);
    const auto& [along, weights] = *found;
    const Attachment row{{v, w, corners[0], corners[1], corners[2]},
                         {1 - along, along, -weights[0], -weights[1], -weights[2]}};
    meetings_.push_back({{v, w, face, -1}, row});
  }
}

void ContactSearch::attachCrossed(Index v, Index w, Index face) {
  for (int k = 0; k < 3; ++k) {
    const auto [a, b] = std::minmax(mesh_.triangles(face, k), mesh_.triangles(face, (k + 1) % 3));
    // Each pair comes along twice, once from either side.
    if (std::pair(a, b) < std::pair(v, w) || (at(b) - at(a)).norm() <= kLong) continue;
    const auto found = nearestBetween(at(v), at(w), at(a), at(b));
    if (!found || found->distance >= kContactReach) continue;
    const auto& [s, t, unused] = *found;
    meetings_.push_back({{v, w, a, b}, {{v, w, a, b, b}, {1 - s, s, t - 1, -t, 0}}});
  }
}

std::vector<Attachment> ContactSearch::take() {
  // Every face of an edge has come across its meetings.
  std::sort(meetings_.begin(), meetings_.end(), [](const Meeting& a, const Meeting& b) { return a.place < b.place; });
  const auto end = std::unique(meetings_.begin(), meetings_.end(),
                               [](const Meeting& a, const Meeting& b) { return a.place == b.place; });
  for (auto each = meetings_.begin(); each != end; ++each) rows_.push_back(each->row);
  return std::move(rows_);
}

}  // namespace whittle
