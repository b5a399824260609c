#pragma once

#include <span>
#include <string>
#include <utility>
#include <vector>

#include "base/status.h"
#include "mesh/unit_frame.h"

namespace whittle {

/// A parameter's value as it comes in from outside: a name, numbers and indices, which each kind reads in its own way.
/// Nothing at all stands for the default.
struct RawValue {
  const char* parameter = "";  // whose value it is, for sentences
  const char* name = "";       // of a choice, or of one of several forms of a value
  std::span<const double> numbers = {};
  std::span<const Index> indices = {};

  bool hasName() const { return *name != 0; }
  bool isEmpty() const { return !hasName() && numbers.empty() && indices.empty(); }
  /// Whether it is these many numbers and nothing else.
  bool isNumbers(std::size_t count) const { return !hasName() && indices.empty() && numbers.size() == count; }

  /// A refusal of it, `what` saying of the parameter what is wrong: "is out of its range".
  Status refused(const std::string& what, Element element = {}) const {
    return Status::failure(Code::badParameter, std::string(parameter) + " " + what, element);
  }
};

/// What values are checked against: a mesh with its vertices as they were loaded.
struct MeshContext {
  Index vertexCount = 0;
  Index faceCount = 0;
  UnitFrame frame;
  const Points* positions = nullptr;  // #V×3, in the file's units
};

/// A raw value that owns what it is made of, for callers that have typed values. Each kind encodes its own.
struct EncodedValue {
  std::string name;
  std::vector<double> numbers;
  std::vector<Index> indices;

  operator RawValue() const { return {.name = name.c_str(), .numbers = numbers, .indices = indices}; }

  /// Appends the entries of a matrix, row by row.
  template <typename Matrix>
  EncodedValue& append(const Matrix& rows) {
    for (Index r = 0; r < rows.rows(); ++r) {
      for (Index c = 0; c < rows.cols(); ++c) numbers.push_back(rows(r, c));
    }
    return *this;
  }
};

inline EncodedValue encoded(double number) { return {{}, {number}, {}}; }
inline EncodedValue encoded(int number) { return encoded(static_cast<double>(number)); }
inline EncodedValue encoded(std::string name) { return {std::move(name), {}, {}}; }
/// Encodes a vector, rows, rotations or a number for each vertex.
inline EncodedValue encoded(const Scalars& numbers) { return EncodedValue().append(numbers); }

}  // namespace whittle
