#pragma once

#include "methods/values/choice.h"

namespace whittle {

/// One of several named ways, or the rows of a matrix in its place.
template <typename Enum>
struct NameOrRows {
  Enum name{};
  Points rows = Points(0, 3);  // #rows×3; none: the name holds

  bool isNamed() const { return rows.rows() == 0; }
  friend bool operator==(const NameOrRows& a, const NameOrRows& b) {
    return a.name == b.name && a.rows.rows() == b.rows.rows() && a.rows == b.rows;
  }
};

/// The shortest and the longest row that is taken.
inline constexpr double kShortestRow = 1e-3;
inline constexpr double kLongestRow = 100;

/// Fails with `badParameter` where rows are too many, or one is not of a length that can be computed with.
Status readRows(const RawValue& raw, Index mostRows, Points& rows);

/// A choice in place of whose name a matrix of one's own will do: the name, or numbers, three a row.
template <typename Enum>
struct ChoiceOrRowsKind {
  using Value = NameOrRows<Enum>;
  static constexpr const char* kName = ChoiceKind<Enum>::kName;
  ChoiceKind<Enum> names;
  Index mostRows;

  Status read(const RawValue& raw, const MeshContext& mesh, Value& value) const {
    Value next;
    Status status = raw.hasName() ? names.read(raw, mesh, next.name) : readRows(raw, mostRows, next.rows);
    if (status.ok()) value = std::move(next);
    return status;
  }
  void describe(const Value& usual, Json& json) const {
    names.describe(usual.name, json);
    json.add("maxRows", mostRows);
  }
};

}  // namespace whittle
