#pragma once

#include <vector>

#include "base/types.h"

namespace whittle {

/// An approximate inverse of a dense symmetric M = I + K of which only some columns of K are known (Nyström):
/// P = s I + C K_RR⁻¹ Cᵀ, C being the columns of the rows R, and s what the other rows have beside that on average.
class LowRankInverse {
 public:
  /// @param C #rows×#known columns of K
  /// @param known the rows that the columns are of
  /// @param rest what s is: 1 or more
  void take(const Eigen::MatrixXd& C, const std::vector<Index>& known, double rest);

  /// P⁻¹ R.
  Eigen::MatrixXd apply(const Eigen::MatrixXd& R) const;

 private:
  Eigen::MatrixXd columns_, inner_;  // C; (s K_RR + Cᵀ C)⁺
  double rest_ = 1;
};

}  // namespace whittle
