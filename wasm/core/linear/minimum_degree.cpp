#include "linear/minimum_degree.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "base/tiering.h"

namespace whittle {

namespace {

constexpr Index kNone = -1;

// What an elimination costs, in the units of `slices.h`: of itself, and for each variable around it.
constexpr double kPivotWork = 1000;
constexpr double kVariableWork = 750;

}  // namespace

MinimumDegree::MinimumDegree(const Graph& graph)
    : n_(graph.size()), lists_(2 * graph.neighbours.size()), start_(n_), size_(n_), elements_(n_, 0), weight_(n_, 1),
      member_(n_), degree_(n_), outside_(n_, {kNone, 0}), head_(n_, kNone), next_(n_), previous_(n_),
      bucket_(n_, kNone), seen_(n_, 0), alive_(n_) {
  std::iota(member_.begin(), member_.end(), 0);
  order_.reserve(n_);
  takeIn(graph);
}

void MinimumDegree::takeIn(const Graph& graph) {
  const double densest = std::max(16.0, 10 * std::sqrt(static_cast<double>(n_)));
  for (Index node = 0; node < n_; ++node) {
    start_[node] = graph.start[node];
    size_[node] = degree_[node] = graph.start[node + 1] - graph.start[node];
    if (degree_[node] <= densest) continue;
    weight_[node] = 0;
    dense_.push_back(node);
    --alive_;
  }
  std::copy(graph.neighbours.begin(), graph.neighbours.end(), lists_.begin());
  listsEnd_ = static_cast<Index>(graph.neighbours.size());
  for (Index node = 0; node < n_; ++node) {
    if (weight_[node] > 0) link(node, degree_[node]);
  }
}

double MinimumDegree::next(double work) {
  for (; alive_ > 0 && work > 0; work -= kPivotWork) {
    const Index pivot = nextPivot();
    formElement(pivot);
    measureOutside(pivot);
    updateVariables(pivot);
    work -= kVariableWork * size_[pivot];
    mergeTwins(pivot);
    closeElement(pivot);
  }
  return alive_ > 0 ? static_cast<double>(order_.size()) / n_ : 1;
}

std::vector<Index> MinimumDegree::take() {
  order_.insert(order_.end(), dense_.begin(), dense_.end());
  return std::move(order_);
}

void MinimumDegree::link(Index variable, Index degree) {
  degree_[variable] = degree;
  lowestDegree_ = std::min(lowestDegree_, degree);
  previous_[variable] = kNone;
  next_[variable] = head_[degree];
  if (next_[variable] != kNone) previous_[next_[variable]] = variable;
  head_[degree] = variable;
}

void MinimumDegree::unlink(Index variable) {
  const Index previous = previous_[variable], next = next_[variable];
  (previous == kNone ? head_[degree_[variable]] : next_[previous]) = next;
  if (next != kNone) previous_[next] = previous;
}

WHITTLE_OWN_FUNCTION Index MinimumDegree::nextPivot() {
  while (head_[lowestDegree_] == kNone) ++lowestDegree_;
  const Index pivot = head_[lowestDegree_];
  unlink(pivot);
  eliminate(pivot);
  return pivot;
}

/// Puts the variable's nodes next in the order.
void MinimumDegree::eliminate(Index variable) {
  alive_ -= std::abs(weight_[variable]);
  weight_[variable] = 0;
  Index node = variable;
  do {
    order_.push_back(node);
    node = member_[node];
  } while (node != variable);
}

/// Forms L_p: the pivot's variables and those of its elements, which it absorbs.
WHITTLE_OWN_FUNCTION void MinimumDegree::formElement(Index pivot) {
  const Index begin = start_[pivot], elementsEnd = begin + elements_[pivot], end = begin + size_[pivot];
  Index most = end - elementsEnd;
  for (Index p = begin; p < elementsEnd; ++p) most += size_[lists_[p]];
  const std::size_t needed = static_cast<std::size_t>(listsEnd_) + most;
  if (needed > lists_.size()) lists_.resize(needed + needed / 2);

  start_[pivot] = listsEnd_;
  elementWeight_ = 0;
  gather(lists_.data() + elementsEnd, end - elementsEnd);
  for (Index p = begin; p < elementsEnd; ++p) {
    const Index element = lists_[p];
    if (degree_[element] == 0) continue;
    gather(lists_.data() + start_[element], size_[element]);
    degree_[element] = 0;
  }
  size_[pivot] = listsEnd_ - start_[pivot];
}

void MinimumDegree::gather(const Index* list, Index count) {
  for (Index k = 0; k < count; ++k) {
    const Index variable = list[k], weight = weight_[variable];
    if (weight <= 0) continue;
    elementWeight_ += weight;
    weight_[variable] = -weight;
    unlink(variable);
    lists_[listsEnd_++] = variable;
  }
}

WHITTLE_OWN_FUNCTION void MinimumDegree::measureOutside(Index pivot) {
  const Index* const lists = lists_.data();
  for (Index k = 0; k < size_[pivot]; ++k) {
    const Index variable = lists[start_[pivot] + k], weight = -weight_[variable];
    for (Index p = start_[variable]; p < start_[variable] + elements_[variable]; ++p) {
      Outside& outside = outside_[lists[p]];
      if (outside.pivot != pivot) outside = {pivot, degree_[lists[p]]};
      outside.weight -= weight;
    }
  }
}

/// New lists and degrees for the variables of L_p, what all of them have in common left out.
WHITTLE_OWN_FUNCTION void MinimumDegree::updateVariables(Index pivot) {
  for (Index k = 0; k < size_[pivot]; ++k) {
    const Index variable = lists_[start_[pivot] + k];
    std::uint32_t hash = 0;
    const Index degree = dropDead(pivot, variable, hash);
    if (degree == 0) {  // all of its neighbours are in L_p: it can go with the pivot
      elementWeight_ += weight_[variable];
      eliminate(variable);
      continue;
    }
    degree_[variable] = std::min(degree_[variable], degree);
    previous_[variable] = static_cast<Index>(hash % n_);
    next_[variable] = std::exchange(bucket_[previous_[variable]], variable);
  }
}

/// Drops from a variable's list what is dead or in L_p, elements inside L_p too, and puts the pivot first, which it has
/// room for because the list held the pivot or an element that it absorbed. Returns the weight of what is left,
/// overlaps counted twice.
Index MinimumDegree::dropDead(Index pivot, Index variable, std::uint32_t& hash) {
  Index* const lists = lists_.data();
  const Index begin = start_[variable], elementsEnd = begin + elements_[variable], end = begin + size_[variable];
  Index degree = 0, kept = begin;
  for (Index p = begin; p < elementsEnd; ++p) {
    const Index element = lists[p], weight = outside_[element].weight;
    if (weight > 0) {
      degree += weight;
      hash += element;
      lists[kept++] = element;
    } else {
      degree_[element] = 0;
    }
  }
  const Index keptElements = kept - begin;
  for (Index p = elementsEnd; p < end; ++p) {
    const Index other = lists[p], weight = weight_[other];
    if (weight <= 0) continue;
    degree += weight;
    hash += other;
    lists[kept++] = other;
  }
  // In front, and the first of the elements and of the variables go to the ends of theirs.
  lists[kept] = lists[begin + keptElements];
  lists[begin + keptElements] = lists[begin];
  lists[begin] = pivot;
  elements_[variable] = keptElements + 1;
  size_[variable] = kept + 1 - begin;
  return degree;
}

WHITTLE_OWN_FUNCTION void MinimumDegree::mergeTwins(Index pivot) {
  for (Index k = 0; k < size_[pivot]; ++k) {
    const Index variable = lists_[start_[pivot] + k];
    if (weight_[variable] == 0) continue;
    Index first = std::exchange(bucket_[previous_[variable]], kNone);
    for (; first != kNone && next_[first] != kNone; first = next_[first]) mergeInto(first);
  }
}

/// Merges with a variable those after it in its bucket that have the same list.
void MinimumDegree::mergeInto(Index variable) {
  const Index* const list = lists_.data() + start_[variable];
  const Index size = size_[variable];
  ++comparison_;
  for (Index p = 1; p < size; ++p) seen_[list[p]] = comparison_;
  const auto isSeen = [this](Index node) { return seen_[node] == comparison_; };
  for (Index before = variable, other = next_[variable]; other != kNone; other = next_[other]) {
    const Index* const others = lists_.data() + start_[other];
    const bool sameSize = size_[other] == size && elements_[other] == elements_[variable];
    if (!sameSize || !std::all_of(others + 1, others + size, isSeen)) {
      before = other;
      continue;
    }
    weight_[variable] += weight_[other];
    weight_[other] = 0;
    std::swap(member_[variable], member_[other]);
    next_[before] = next_[other];
  }
}

/// Gives the variables of L_p their places by degree.
WHITTLE_OWN_FUNCTION void MinimumDegree::closeElement(Index pivot) {
  const Index begin = start_[pivot], end = begin + size_[pivot];
  Index kept = begin;
  for (Index p = begin; p < end; ++p) {
    const Index variable = lists_[p], weight = -weight_[variable];
    if (weight == 0) continue;
    weight_[variable] = weight;
    link(variable, std::min(degree_[variable] + elementWeight_, alive_) - weight);
    lists_[kept++] = variable;
  }
  listsEnd_ = kept;
  size_[pivot] = kept - begin;
  degree_[pivot] = elementWeight_;
}

}  // namespace whittle
