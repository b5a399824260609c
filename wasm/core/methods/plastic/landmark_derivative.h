#pragma once

#include "methods/plastic/sensitivity.h"
#include "methods/plastic/shell_system.h"

namespace whittle {

/// A point of the surface that is to come to a place: weights on up to three vertices.
struct Landmark {
  std::array<Index, 3> vertices = {-1, -1, -1};
  Vec3 weights = Vec3::Zero();
  Vec3 target = Vec3::Zero();

  Vec3 at(const Points& positions) const;
};

/// J, how landmarks move as the plastic field of a shell changes and the shell stays in equilibrium: − C K⁻¹ f_p, C taking
/// the landmarks' points from the vertices. A row is a coordinate of a landmark. It is never there as a whole; products are
/// made some columns at a time, slice by slice.
class LandmarkDerivative {
 public:
  using Rows = Sensitivity::Rows;

  /// All is kept by the caller as long as this is used; the system holds the factor of the shell in its present shape.
  void begin(const Shell& shell, const std::vector<Landmark>& landmarks, ShellSystem& system);
  Index rows() const { return 3 * static_cast<Index>(landmarks_->size()); }

  /// Begins to multiply columns (6 #F×k) by J, or columns (#rows×k) by Jᵀ; `next` does it. Kept by the caller until then.
  /// @param isRough solved in single precision, which is enough for a search direction
  void beginProduct(const Rows& fields, bool isRough = false);
  void beginTransposed(const Rows& combinations, bool isRough = false);
  Status next(bool& isDone);
  /// The product.
  Rows& result() { return result_; }

  /// Begins to find how the shape follows a change of the field under forces (#V×3): − K⁻¹ (f + f_p q), in `result`,
  /// 3 #V×1.
  void beginMove(const Scalars& change, const Points& forces);

  /// What the points of the landmarks are of displacements of the vertices (3 #V×k).
  void takeRows(const Rows& displacements, Index column, Index count, Rows& ofRows) const;

 private:
  enum class Kind { product, transposed, move };

  void load();
  void finish();
  void scatter();

  const Shell* shell_ = nullptr;
  const std::vector<Landmark>* landmarks_ = nullptr;
  ShellSystem* system_ = nullptr;
  Sensitivity sensitivity_;
  Kind kind_ = Kind::product;
  const Rows* columns_ = nullptr;
  bool isRough_ = false;
  int stage_ = 0;    // of the batch: to be loaded, to be solved, to be finished
  Index next_ = 0;   // column
  Index width_ = 0;  // of the batch
  Rows own_;         // the change of a move
  const Points* forces_ = nullptr;
  Rows batch_, loads_, displacements_, part_, result_;
};

}  // namespace whittle
