#pragma once

#include "base/types.h"

namespace whittle {

/// a⁺ of a symmetric positive semidefinite matrix: eigenvalues that are a smaller share of the largest count as none.
Eigen::MatrixXd pseudoInverse(const Eigen::MatrixXd& a, double share);

}  // namespace whittle
