#include "methods/plastic/landmark_derivative.h"

#include <algorithm>

namespace whittle {

namespace {

/// Columns of a batch: fewer where each is long or solved in double precision, so that a slice stays short.
Index batchWidth(Index unknowns, bool isRough) {
  constexpr Index kGroup = 3;
  const Index numbers = isRough ? 450000 : 160000;
  return std::clamp<Index>(numbers / std::max<Index>(unknowns, 1) / kGroup * kGroup, kGroup,
                           ConjugateGradients::kBatch);
}

}  // namespace

Vec3 Landmark::at(const Points& positions) const {
  Vec3 place = Vec3::Zero();
  for (int i = 0; i < 3; ++i) {
    if (vertices[i] >= 0) place += weights[i] * positions.row(vertices[i]).transpose();
  }
  return place;
}

void LandmarkDerivative::begin(const Shell& shell, const std::vector<Landmark>& landmarks, ShellSystem& system) {
  shell_ = &shell;
  landmarks_ = &landmarks;
  system_ = &system;
  sensitivity_.take(shell);
}

void LandmarkDerivative::beginProduct(const Rows& fields, bool isRough) {
  kind_ = Kind::product;
  columns_ = &fields;
  isRough_ = isRough;
  next_ = stage_ = 0;
  result_.resize(rows(), fields.cols());
}

void LandmarkDerivative::beginTransposed(const Rows& combinations, bool isRough) {
  kind_ = Kind::transposed;
  columns_ = &combinations;
  isRough_ = isRough;
  next_ = stage_ = 0;
  result_.resize(6 * shell_->faceCount(), combinations.cols());
}

void LandmarkDerivative::beginMove(const Scalars& change, const Points& forces) {
  kind_ = Kind::move;
  own_ = change;
  columns_ = &own_;
  forces_ = &forces;
  isRough_ = false;
  next_ = stage_ = 0;
  result_.resize(3 * shell_->vertexCount(), 1);
}

Status LandmarkDerivative::next(bool& isDone) {
  Status status;
  const Index count = static_cast<Index>(columns_->cols());
  isDone = count == 0;
  if (isDone) return status;
  if (stage_ == 0) {
    width_ = std::min(batchWidth(system_->unknowns(), isRough_), count - next_);
    load();
    stage_ = 1;
  } else if (stage_ == 1) {
    if (isRough_) {
      system_->approximate(loads_);
    } else {
      status = system_->solve(loads_);
    }
    stage_ = 2;
  } else {
    finish();
    next_ += width_;
    stage_ = 0;
    isDone = next_ == count;
  }
  return status;
}

/// Forces on the nodes: those of a change of the field, or unit forces at the landmarks.
void LandmarkDerivative::load() {
  const std::vector<Index>& nodeOf = system_->nodeOf();
  loads_.setZero(system_->unknowns(), width_);
  if (kind_ == Kind::transposed) {
    for (Index l = 0; l < static_cast<Index>(landmarks_->size()); ++l) {
      const Landmark& landmark = (*landmarks_)[l];
      for (int i = 0; i < 3; ++i) {
        const Index node = landmark.vertices[i] < 0 ? -1 : nodeOf[landmark.vertices[i]];
        if (node >= 0) loads_.middleRows(3 * node, 3) += landmark.weights[i] * columns_->block(3 * l, next_, 3, width_);
      }
    }
    return;
  }
  batch_ = columns_->middleCols(next_, width_);
  sensitivity_.apply(batch_, displacements_);
  for (std::size_t v = 0; v < nodeOf.size(); ++v) {
    if (nodeOf[v] < 0) continue;
    const Index vertex = static_cast<Index>(v);
    loads_.middleRows(3 * nodeOf[v], 3) = -displacements_.middleRows(3 * vertex, 3);
    if (kind_ == Kind::move) loads_.middleRows(3 * nodeOf[v], 3) -= forces_->row(vertex).transpose();
  }
}

void LandmarkDerivative::scatter() {
  const std::vector<Index>& nodeOf = system_->nodeOf();
  displacements_.setZero(3 * shell_->vertexCount(), width_);
  for (std::size_t v = 0; v < nodeOf.size(); ++v) {
    if (nodeOf[v] >= 0) displacements_.middleRows(3 * static_cast<Index>(v), 3) = loads_.middleRows(3 * nodeOf[v], 3);
  }
}

void LandmarkDerivative::finish() {
  scatter();
  if (kind_ == Kind::transposed) {
    sensitivity_.applyTransposed(displacements_, part_);
    result_.middleCols(next_, width_) = -part_;
  } else if (kind_ == Kind::product) {
    takeRows(displacements_, next_, width_, result_);
  } else {
    result_ = displacements_;
  }
}

void LandmarkDerivative::takeRows(const Rows& displacements, Index column, Index count, Rows& ofRows) const {
  for (Index l = 0; l < static_cast<Index>(landmarks_->size()); ++l) {
    auto rows = ofRows.block(3 * l, column, 3, count);
    rows.setZero();
    for (int i = 0; i < 3; ++i) {
      const Landmark& landmark = (*landmarks_)[l];
      if (landmark.vertices[i] >= 0)
        rows += landmark.weights[i] * displacements.middleRows(3 * landmark.vertices[i], 3).leftCols(count);
    }
  }
}

}  // namespace whittle
