#pragma once

#include "base/types.h"

namespace whittle {

using Box = Eigen::AlignedBox3d;

/// The smallest box around finite positions (#V×3).
Box boundingBox(const Points& positions);

}  // namespace whittle
