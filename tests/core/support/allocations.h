#pragma once

namespace whittle::testing {

/// How often memory was claimed so far, by `new` or by Eigen.
long allocationCount();

}  // namespace whittle::testing
