#pragma once

#include <concepts>
#include <type_traits>

#include "base/types.h"

namespace whittle {

/// Some columns of numbers (#rows×k), such as right-hand sides or solutions, where their owner keeps them: a dense
/// matrix of doubles, row-major or column-major, or a block of one. It is a view and lives no longer than the matrix.
template <typename Number>
class BasicColumns {
 public:
  template <typename Dense>
  requires requires(Dense& X) {
    { X.data() } -> std::convertible_to<Number*>;
    { X.rowStride() } -> std::convertible_to<Eigen::Index>;
  }
  BasicColumns(Dense&& X)
      : data_(X.data()), rows_(static_cast<Index>(X.rows())), count_(static_cast<Index>(X.cols())),
        rowStride_(X.rowStride()), columnStride_(X.colStride()) {}
  /// A view for writing is one for reading too.
  operator BasicColumns<const Number>() const requires(!std::is_const_v<Number>) {
    return {data_, rows_, count_, rowStride_, columnStride_};
  }

  Index rows() const { return rows_; }
  /// How many columns there are.
  Index count() const { return count_; }
  Number& operator()(Index row, Index column) const { return data_[row * rowStride_ + column * columnStride_]; }
  /// `count` columns from `first` on.
  BasicColumns part(Index first, Index count) const {
    return {data_ + first * columnStride_, rows_, count, rowStride_, columnStride_};
  }

 private:
  template <typename>
  friend class BasicColumns;
  BasicColumns(Number* data, Index rows, Index count, Eigen::Index rowStride, Eigen::Index columnStride)
      : data_(data), rows_(rows), count_(count), rowStride_(rowStride), columnStride_(columnStride) {}

  Number* data_;
  Index rows_, count_;
  Eigen::Index rowStride_, columnStride_;
};

using Columns = BasicColumns<double>;
using ConstColumns = BasicColumns<const double>;

}  // namespace whittle
