#include "remeshing/scaffold.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numeric>
#include <tuple>

namespace whittle {

namespace {

/// Room between the mesh and the box, as a share of its longest side. With some, no corner comes between two parts that
/// are each other's nearest, so that parts are tied without corners too.
constexpr double kMargin = 0.05;
constexpr Index kMadeInSlice = 40000, kTetrahedraOfSlice = 60000, kPointsOfSlice = 15000;
/// Surfaces make some 7 tetrahedra a point. Beyond this many points are left out.
constexpr std::size_t kMostTetrahedra = 40, kTetrahedraAnyhow = 100000;
constexpr int kMostRounds = 20;

/// In which round, from 0, a place is added: half of all places in the last, half of the rest in the one before, and so
/// on, as chance has it. What is already there is then everywhere, and no place changes much.
int roundOf(std::uint64_t key) {
  const std::uint64_t mixed = (key ^ key >> 29) * 0x9e3779b97f4a7c15u;
  return kMostRounds - std::min(kMostRounds - 1, std::countl_zero(mixed));
}

}  // namespace

ScaffoldSearch::ScaffoldSearch(const Points& positions, std::vector<Index> partOfVertex)
    : positions_(positions), partOf_(std::move(partOfVertex)) {}

double ScaffoldSearch::next() {
  switch (stage_) {
    case Stage::places:
      measureBox();
      collectPlaces();
      orderPlaces();
      enter(Stage::adding);
      break;
    case Stage::adding: addPlaces(); break;
    case Stage::counting: countEdges(); break;
    case Stage::collecting: collectEdges(); break;
    case Stage::emitting: emitEdges(); break;
    case Stage::done: break;
  }
  return share();
}

double ScaffoldSearch::share() const {
  const auto ofStage = [&](std::size_t count) { return next_ / std::max<double>(static_cast<double>(count), 1); };
  switch (stage_) {
    case Stage::places: return 0;
    case Stage::adding: return 0.05 + 0.75 * ofStage(places_.size());
    case Stage::counting: return 0.8 + 0.05 * ofStage(tetrahedra_->tetrahedra().size());
    case Stage::collecting: return 0.85 + 0.05 * ofStage(tetrahedra_->tetrahedra().size());
    case Stage::emitting: return 0.9 + 0.1 * ofStage(places_.size() + kCorners + 1);
    case Stage::done: break;
  }
  return 1;
}

void ScaffoldSearch::enter(Stage stage) {
  stage_ = stage;
  next_ = 0;
}

void ScaffoldSearch::measureBox() {
  for (Index v = 0; v < positions_.rows(); ++v) {
    if (partOf_[v] >= 0) box_.extend(positions_.row(v).transpose());
  }
  if (box_.isEmpty()) box_.extend(Vec3::Zero());
  double longest = box_.sizes().maxCoeff();
  if (!(longest > 0)) longest = 1;
  least_ = Scaffold::kLeastLength * longest;
  const Vec3 margin = Vec3::Constant(kMargin * longest);
  box_ = Box(box_.min() - margin, box_.max() + margin);
  scale_ = ((1 << LatticePoint::kBits) - 1) / (longest * (1 + 2 * kMargin));
}

LatticePoint ScaffoldSearch::onLattice(const Eigen::RowVector3d& position) const {
  const Vec3 scaled = (position.transpose() - box_.min()) * scale_;
  const auto rounded = [](double x) { return static_cast<std::int32_t>(std::floor(x + 0.5)); };
  return {rounded(scaled[0]), rounded(scaled[1]), rounded(scaled[2])};
}

void ScaffoldSearch::collectPlaces() {
  std::vector<std::tuple<std::uint64_t, Index, Index>> sorted;  // key, part, vertex
  sorted.reserve(partOf_.size());
  for (Index v = 0; v < positions_.rows(); ++v) {
    if (partOf_[v] >= 0) sorted.emplace_back(onLattice(positions_.row(v)).key(), partOf_[v], v);
  }
  std::sort(sorted.begin(), sorted.end());
  for (std::size_t i = 0; i < sorted.size(); ++i) {
    const auto& [key, part, v] = sorted[i];
    const bool isNew = i == 0 || key != std::get<0>(sorted[i - 1]);
    if (!isNew && part == std::get<1>(sorted[i - 1])) continue;
    const Index last = static_cast<Index>(vertices_.size());
    if (isNew) places_.push_back({onLattice(positions_.row(v)), last, last});
    vertices_.push_back(v);
    ++places_.back().last;
  }
}

void ScaffoldSearch::orderPlaces() {
  const Index count = static_cast<Index>(places_.size());
  std::vector<bool> isThere(partOf_.empty() ? 1 : *std::max_element(partOf_.begin(), partOf_.end()) + 1, false);
  std::vector<int> round(count);
  std::vector<Index> next(kMostRounds + 2, 0);
  for (Index i = 0; i < count; ++i) {
    round[i] = roundOf(places_[i].point.key());
    for (Index k = places_[i].first; k < places_[i].last; ++k) {
      const Index part = partOf_[vertices_[k]];
      if (!isThere[part]) round[i] = 0;
      isThere[part] = true;
    }
    ++next[round[i] + 1];
  }
  mustAdd_ = next[1];
  std::partial_sum(next.begin(), next.end(), next.begin());
  order_.resize(count);
  for (Index i = 0; i < count; ++i) order_[next[round[i]]++] = i;
  scaffold_.corners.resize(kCorners, 3);
  for (Index corner = 0; corner < kCorners; ++corner) {
    scaffold_.corners.row(corner) = box_.corner(static_cast<Box::CornerType>(corner)).transpose();
  }
  tetrahedra_.emplace(onLattice(scaffold_.corners.row(0)), onLattice(scaffold_.corners.row(7)));
  tetrahedra_->reserve(count + kCorners);
}

void ScaffoldSearch::addPlaces() {
  const Index count = static_cast<Index>(places_.size());
  const std::int64_t end = tetrahedra_->made() + kMadeInSlice;
  const std::size_t most = kMostTetrahedra * places_.size() + kTetrahedraAnyhow;
  bool isFull = false;
  for (; next_ < count && !isFull && tetrahedra_->made() < end; ++next_) {
    tetrahedra_->add(places_[order_[next_]].point);
    isFull = next_ >= mustAdd_ && tetrahedra_->tetrahedra().size() > most;
  }
  if (next_ == count || isFull) enter(Stage::counting);
}

/// Calls `visit(low, high)` for the edges that count of a slice of the tetrahedra; returns whether that was the last.
template <typename Visit>
bool ScaffoldSearch::visitEdges(Visit&& visit) {
  const auto& tetrahedra = tetrahedra_->tetrahedra();
  const Index count = static_cast<Index>(tetrahedra.size());
  for (const Index end = std::min(count, next_ + kTetrahedraOfSlice); next_ < end; ++next_) {
    const auto& points = tetrahedra[next_].points;
    if (points[0] < 0) continue;
    for (int i = 0; i < 3; ++i) {
      for (int k = i + 1; k < 4; ++k) {
        const auto [low, high] = std::minmax(points[i], points[k]);
        if (high < kCorners) continue;
        if (low < kCorners || haveSeveralParts(placeOf(low), placeOf(high))) visit(low, high);
      }
    }
  }
  return next_ == count;
}

void ScaffoldSearch::countEdges() {
  if (next_ == 0) start_.assign(tetrahedra_->pointCount() + 2, 0);
  if (!visitEdges([&](Index low, Index) { ++start_[low + 2]; })) return;
  std::partial_sum(start_.begin(), start_.end(), start_.begin());
  ends_.resize(start_.back());
  enter(Stage::collecting);
}

void ScaffoldSearch::collectEdges() {
  if (visitEdges([&](Index low, Index high) { ends_[start_[low + 1]++] = high; })) enter(Stage::emitting);
}

void ScaffoldSearch::emitEdges() {
  const Index count = tetrahedra_->pointCount();
  for (const Index end = std::min(count, next_ + kPointsOfSlice); next_ < end; ++next_) {
    const auto first = ends_.begin() + start_[next_], last = ends_.begin() + start_[next_ + 1];
    std::sort(first, last);
    for (auto other = first; other != last; ++other) {
      if (other != first && *other == *(other - 1)) continue;
      if (next_ < kCorners) {
        tieToCorner(placeOf(*other), next_);
      } else {
        tie(placeOf(next_), placeOf(*other));
      }
    }
  }
  if (next_ == count) enter(Stage::done);
}

/// Ties each vertex of the one place to the first of another part in the other, and the other way round.
void ScaffoldSearch::tie(const Place& a, const Place& b) {
  const auto add = [&](Index v, Index w) {
    scaffold_.betweenParts.push_back(edge(std::min(v, w), std::max(v, w), positions_.row(v), positions_.row(w)));
  };
  for (Index i = a.first; i < a.last; ++i) {
    const Index v = vertices_[i], w = firstOfOthers(partOf_[v], b);
    if (w >= 0) add(v, w);
  }
  for (Index i = b.first; i < b.last; ++i) {
    const Index v = vertices_[i], w = firstOfOthers(partOf_[v], a);
    if (w >= 0 && firstOfOthers(partOf_[w], b) != v) add(v, w);
  }
}

void ScaffoldSearch::tieToCorner(const Place& place, int corner) {
  for (Index i = place.first; i < place.last; ++i) {
    const Index v = vertices_[i];
    scaffold_.toCorners.push_back(
        edge(v, static_cast<Index>(positions_.rows()) + corner, positions_.row(v), scaffold_.corners.row(corner)));
  }
}

/// A vertex at a place that is not of a part, or −1.
Index ScaffoldSearch::firstOfOthers(Index part, const Place& place) const {
  for (Index i = place.first; i < std::min(place.last, place.first + 2); ++i) {
    if (partOf_[vertices_[i]] != part) return vertices_[i];
  }
  return -1;
}

bool ScaffoldSearch::haveSeveralParts(const Place& a, const Place& b) const {
  return a.last - a.first > 1 || b.last - b.first > 1 || partOf_[vertices_[a.first]] != partOf_[vertices_[b.first]];
}

Scaffold::Edge ScaffoldSearch::edge(Index v, Index w, const Eigen::RowVector3d& from,
                                    const Eigen::RowVector3d& to) const {
  return {v, w, std::max((to - from).norm(), least_)};
}

}  // namespace whittle
