#pragma once

#include <vector>

#include "linear/graph.h"
#include "linear/slices.h"

namespace whittle {

/// Elimination order by approximate minimum degree (Amestoy, Davis and Duff 1996). Keeps the factor of matrices on a
/// graph sparse. Nodes of very many neighbours, more than ten times √#nodes, go last.
///
/// Elimination on the quotient graph. An eliminated node p becomes an element: the clique that it leaves is kept as the
/// list of its variables, L_p, and never written out. Variables that nothing tells apart any more become one of larger
/// weight. The list of a variable holds its elements, then its variables; it only shrinks, so it stays in its place,
/// and what is dead in it is dropped when it is looked through.
class MinimumDegree {
 public:
  explicit MinimumDegree(const Graph& graph);
  /// Eliminates for a slice; returns the share of the nodes that are.
  double next(double work = kSliceWork);
  /// The order, position → node, once all are eliminated.
  std::vector<Index> take();

 private:
  /// |L_e \ L_p| of an element e, for the pivot p that it was measured for.
  struct Outside {
    Index pivot, weight;
  };

  void takeIn(const Graph& graph);
  Index nextPivot();
  void formElement(Index pivot);
  void gather(const Index* list, Index count);
  void measureOutside(Index pivot);
  void updateVariables(Index pivot);
  Index dropDead(Index pivot, Index variable, std::uint32_t& hash);
  void mergeTwins(Index pivot);
  void mergeInto(Index variable);
  void closeElement(Index pivot);
  void link(Index variable, Index degree);
  void unlink(Index variable);
  void eliminate(Index variable);

  const Index n_;
  std::vector<Index> lists_;  // of variables, then of elements as they are formed
  Index listsEnd_ = 0;
  std::vector<Index> start_, size_;  // of each node's list
  std::vector<Index> elements_;      // how many of a variable's list are elements
  std::vector<Index> weight_;        // nodes in each variable, below 0 while it is in L_p; 0: not a variable any more
  std::vector<Index> member_;        // rings of the nodes of each variable
  std::vector<Index> degree_;        // of a variable, at most; of an element |L_e|, 0 once it is dead
  std::vector<Outside> outside_;     // of elements
  std::vector<Index> head_, next_, previous_;  // variables by degree
  std::vector<Index>
      bucket_;  // variables of L_p by the hash of their lists, chained by `next_`; `previous_` holds the hash
  std::vector<Index> seen_;  // the comparison that last met a node
  Index comparison_ = 0;
  Index lowestDegree_ = 0;
  Index elementWeight_ = 0;   // |L_p|
  Index alive_;               // nodes not eliminated yet, dense ones left out
  std::vector<Index> dense_;  // nodes left out, which go last
  std::vector<Index> order_;
};

}  // namespace whittle
