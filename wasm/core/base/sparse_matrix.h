#pragma once

#include <Eigen/SparseCore>

#include "base/types.h"

namespace whittle {

/// Compressed columns; symmetric matrices are stored whole.
using SparseMatrix = Eigen::SparseMatrix<double, Eigen::ColMajor, Index>;

}  // namespace whittle
