#pragma once

#include "methods/local_global/edges/stiff_edges.h"

namespace whittle {

/// How far the vertices are from rest, δ = V − V₀: rows in single precision, and in double precision those of the
/// vertices of stiff edges, of which the rows are the rounding.
class Displacements {
 public:
  /// Claims memory, all of it zero. @param stiff is referred to, not copied
  void resize(Index vertexCount, const StiffEdges& stiff) {
    stiff_ = &stiff;
    rows_.assign(4 * batchCount(vertexCount), {});
    exact_ = Points::Zero(stiff.vertices().size(), 3);
  }

  const LaneRows& rows() const { return rows_; }
  LaneRows& rows() { return rows_; }
  /// #stiff vertices×3
  const Points& exact() const { return exact_; }

  /// V − V₀
  void measure(const Points& positions, const Points& rest);
  /// V₀ + δ
  void apply(const Points& rest, Points& positions) const;

  /// Becomes a + s (b − c), of which it may be one.
  void combine(const Displacements& a, double s, const Displacements& b, const Displacements& c);
  /// Makes those of stiff edges what `of(place, vertex)` says.
  template <typename Of>
  void setExact(Of&& of) {
    for (Index place = 0; place < exact_.rows(); ++place) {
      const Index v = stiff_->vertices()[place];
      exact_.row(place) = of(place, v);
      setRow(rows_[v], exact_.row(place).transpose());
    }
  }

 private:
  const StiffEdges* stiff_ = nullptr;
  LaneRows rows_;
  Points exact_;
};

}  // namespace whittle
