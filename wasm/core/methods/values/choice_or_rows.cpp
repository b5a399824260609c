#include "methods/values/choice_or_rows.h"

namespace whittle {

Status readRows(const RawValue& raw, Index mostRows, Points& rows) {
  const Index count = static_cast<Index>(raw.numbers.size() / 3);
  if (!raw.isNumbers(3 * count) || count > mostRows) {
    return raw.refused("must have " + std::to_string(mostRows) + " rows of three numbers at most");
  }
  rows = Eigen::Map<const Points>(raw.numbers.data(), count, 3);
  for (Index row = 0; row < count; ++row) {
    const double length = rows.row(row).norm();
    if (length >= kShortestRow && length <= kLongestRow) continue;
    return raw.refused("must have rows from 0.001 to 100 long; row {} is not", Element::item(row));
  }
  return {};
}

}  // namespace whittle
