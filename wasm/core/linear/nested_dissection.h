#pragma once

#include <memory>
#include <vector>

#include "linear/bisector.h"
#include "linear/graph.h"
#include "linear/slices.h"

namespace whittle {

/// Elimination order by nested dissection (George 1973). Each part is cut in two across the best of several
/// directions in space; the smallest set of nodes that separates the halves goes last, and small parts are ordered by
/// minimum degree. Coordinates (#nodes×3) only suggest where to cut: coincident ones or ones that have nothing to do
/// with the graph cost fill, never correctness.
///
/// The order is built in place: a part is a range of the nodes, cut into [low | high | separator].
class NestedDissection {
 public:
  /// @param graph to be kept by the caller until the order is there, like the coordinates
  NestedDissection(const Graph& graph, const Points& coordinates);
  ~NestedDissection();

  /// Cuts and orders parts for a slice; returns the share that is done.
  double next(double work = kSliceWork);
  /// The order, position → node, once all is done.
  std::vector<Index> take();

 private:
  struct Range {
    Index first, last;
    Index count() const { return last - first; }
  };
  /// A part that is being ordered by minimum degree.
  struct Leaf;

  bool bisect(Range range);
  void beginLeaf(Range range);
  Graph leafGraph(Range range);
  void finishLeaf();

  const Graph& graph_;
  std::vector<Index> nodes_;
  std::vector<Index> part_;  // of each node; kSettled: its place is final, it belongs to a separator or a leaf
  Bisector bisector_;
  std::vector<Range> waiting_;  // parts that are neither cut nor ordered yet
  std::unique_ptr<Leaf> leaf_;  // where one is begun
  std::vector<Index> place_;    // of the nodes of a leaf and around it, in its own numbering
  Index parts_ = 1;
  double workLeft_ = 0, allWork_ = 0;  // as it is expected
};

}  // namespace whittle
