#include "methods/plastic/landmark_step.h"

#include <algorithm>
#include <limits>

#include "optimization/pseudo_inverse.h"

namespace whittle {

namespace {

/// So many landmarks are solved for as a whole; of more, so many have columns that precondition, and so many more tell
/// what these leave.
constexpr std::size_t kFew = 26, kKnown = 24, kProbes = 2;
/// Columns that say no more than others do.
constexpr double kSame = 1e-10;

}  // namespace

void LandmarkStep::begin(const Problem& problem, ShellSystem& system, PlasticPrior& prior) {
  problem_.emplace(problem);
  prior_ = &prior;
  system_ = &system;
  stage_ = Stage::derivative;
  isBegun_ = false;
}

/// Chooses the landmarks whose columns are made: all, or the farthest from those chosen before, probes last.
void LandmarkStep::choose() {
  const std::vector<Landmark>& all = problem_->landmarks;
  const Points& positions = problem_->shell.input().positions;
  known_.clear();
  std::vector<double> distances(all.size(), std::numeric_limits<double>::infinity());
  const std::size_t count = all.size() <= kFew ? all.size() : kKnown + kProbes;
  while (known_.size() < count) {
    const auto farthest = std::max_element(distances.begin(), distances.end());
    const Index next = static_cast<Index>(farthest - distances.begin());
    known_.push_back(next);
    const Vec3 place = all[next].at(positions);
    for (std::size_t l = 0; l < all.size(); ++l)
      distances[l] = std::min(distances[l], (all[l].at(positions) - place).squaredNorm());
    distances[next] = -1;
  }
  if (all.size() == count) {
    for (std::size_t l = 0; l < count; ++l) known_[l] = static_cast<Index>(l);
  }
  selection_.setZero(3 * static_cast<Index>(all.size()), 3 * static_cast<Index>(count));
  for (std::size_t k = 0; k < count; ++k)
    selection_.block<3, 3>(3 * known_[k], 3 * static_cast<Index>(k)).setIdentity();
}

Status LandmarkStep::next(bool& isDone) {
  const Status status = advance();
  isDone = stage_ == Stage::done;
  return status;
}

Status LandmarkStep::advance() {
  bool isReady = false;
  Status status;
  Stage next = Stage::done;
  switch (stage_) {
    case Stage::derivative:
      derivative_.begin(problem_->shell, problem_->landmarks, *system_);
      choose();
      isReady = true;
      next = Stage::offset;
      break;
    case Stage::offset:
      status = findTarget(isReady);
      next = Stage::transposed;
      break;
    case Stage::transposed:
      status = findTransposed(isReady);
      next = Stage::kept;
      break;
    case Stage::kept:
      if (begins()) prior_->beginSolve(kept_, !isWhole());
      status = prior_->solveNext(isReady);
      next = Stage::images;
      break;
    case Stage::images:
      status = isWhole() ? solveWhole(isReady) : findImages(isReady);
      next = isWhole() ? Stage::move : Stage::descent;
      break;
    case Stage::descent:
    case Stage::field: return descend();
    case Stage::move: status = findMove(isReady); break;
    case Stage::done: return {};
  }
  if (isReady) go(next);
  return status;
}

void LandmarkStep::go(Stage next) {
  stage_ = next;
  isBegun_ = false;
}

Status LandmarkStep::findTarget(bool& isReady) {
  if (begins()) {
    forces_.resize(problem_->shell.vertexCount(), 3);
    problem_->shell.energy(forces_);
    derivative_.beginMove(-problem_->field, forces_);
  }
  const Status status = derivative_.next(isReady);
  if (isReady) setTarget();
  return status;
}

Status LandmarkStep::findTransposed(bool& isReady) {
  if (begins()) derivative_.beginTransposed(selection_, !isWhole());
  const Status status = derivative_.next(isReady);
  if (!isReady) return status;
  transposed_ = derivative_.result();
  kept_ = transposed_;
  return status;
}

Status LandmarkStep::findImages(bool& isReady) {
  if (begins()) {
    const Index growth = static_cast<Index>(prior_->growth().cols());
    kept_.conservativeResize(kept_.rows(), kept_.cols() + growth);
    kept_.rightCols(growth) = prior_->growth();
    derivative_.beginProduct(kept_, true);
  }
  const Status status = derivative_.next(isReady);
  if (!isReady) return status;
  setImages();
  beginDescent();
  return status;
}

Status LandmarkStep::findMove(bool& isReady) {
  if (begins()) derivative_.beginMove(change_, forces_);
  const Status status = derivative_.next(isReady);
  if (isReady) move_ = Eigen::Map<const Points>(derivative_.result().data(), problem_->shell.vertexCount(), 3);
  return status;
}

/// J q − r + C K⁻¹ f: what the change of the field from nothing has to do, the shape being off its equilibrium by f.
void LandmarkStep::setTarget() {
  Rows column(derivative_.rows(), 1);
  derivative_.takeRows(derivative_.result(), 0, 1, column);
  target_ = -column.col(0);
  const Points& positions = problem_->shell.input().positions;
  for (Index l = 0; l < static_cast<Index>(problem_->landmarks.size()); ++l)
    target_.segment<3>(3 * l) += problem_->landmarks[l].target - problem_->landmarks[l].at(positions);
}

/// J A⁻¹ Jᵀ, as far as it is made, and what rigid motions and free growth do to the landmarks.
void LandmarkStep::setImages() {
  const Index rigid = problem_->modes.count(), growth = static_cast<Index>(prior_->growth().cols());
  G_.setZero(derivative_.rows(), rigid + growth);
  for (Index l = 0; l < static_cast<Index>(problem_->landmarks.size()); ++l) {
    const Landmark& landmark = problem_->landmarks[l];
    for (int i = 0; i < 3; ++i) {
      if (landmark.vertices[i] >= 0)
        G_.block(3 * l, 0, 3, rigid) += landmark.weights[i] * problem_->modes.velocities(landmark.vertices[i]);
    }
  }
  if (isWhole()) {
    images_ = transposed_.transpose() * kept_;
    G_.rightCols(growth) = transposed_.transpose() * prior_->growth();
  } else {
    images_ = derivative_.result().leftCols(selection_.cols());
    G_.rightCols(growth) = derivative_.result().rightCols(growth);
  }
}

Status LandmarkStep::solveWhole(bool& isReady) {
  setImages();
  const Status status = solveDual(images_, target_, G_, dual_);
  isReady = status.ok();
  if (isReady) takeField(kept_ * dual_.multipliers);
  return status;
}

void LandmarkStep::takeField(const Rows& kept) {
  const Index growth = static_cast<Index>(prior_->growth().cols());
  const Scalars field = kept.col(0) + prior_->growth() * dual_.free.tail(growth);
  change_ = field - problem_->field;
  rigid_ = dual_.free.head(problem_->modes.count());
  model_ = dual_.multipliers.squaredNorm() + prior_->energy(field);
}

void LandmarkStep::beginDescent() {
  const Index columns = 3 * static_cast<Index>(kKnown);
  std::vector<Index> rows;
  for (Index c = 0; c < columns; ++c) rows.push_back(3 * known_[c / 3] + c % 3);
  const Eigen::MatrixXd C = images_.leftCols(columns);
  inverse_.take(C, rows, 1);
  // What the rows of the probes have beside what the known columns say of them.
  Eigen::MatrixXd K(columns, columns);
  for (Index c = 0; c < columns; ++c) K.row(c) = C.row(rows[c]);
  const Eigen::MatrixXd inverse = pseudoInverse(K, kSame);
  double rest = 0;
  for (Index p = 0; p < 3 * static_cast<Index>(kProbes); ++p) {
    const Index row = 3 * known_[kKnown + p / 3] + p % 3;
    rest += std::max(0.0, images_(row, columns + p) - C.row(row).dot(inverse * C.row(row).transpose()));
  }
  inverse_.take(C, rows, 1 + rest / (3 * kProbes));
  descent_.begin(target_, G_, inverse_, {});
  part_ = 0;
}

/// Multiplies by J A⁻¹ Jᵀ: a direction of the descent, and at its end what has been found, for the field.
Status LandmarkStep::descend() {
  if (stage_ == Stage::descent && descent_.isDone()) {
    go(Stage::field);
    part_ = 0;
  }
  const bool isLast = stage_ == Stage::field;
  bool isReady = false;
  Status status;
  if (part_ == 0) {
    if (begins()) {
      combination_ = isLast ? descent_.multipliers() : descent_.direction();
      derivative_.beginTransposed(combination_, !isLast);
    }
    status = derivative_.next(isReady);
    if (isReady) column_ = derivative_.result();
  } else if (part_ == 1) {
    if (begins()) prior_->beginSolve(column_, !isLast);
    status = prior_->solveNext(isReady);
  } else {
    if (begins()) derivative_.beginProduct(column_, true);
    status = derivative_.next(isReady);
    if (isReady) descent_.advance(combination_.col(0) + derivative_.result().col(0));
  }
  if (!isReady) return status;
  go(stage_);
  if (isLast && part_ == 1) {
    dual_.multipliers = descent_.multipliers();
    dual_.free = descent_.free();
    takeField(column_);
    go(Stage::move);
  }
  part_ = (part_ + 1) % 3;
  return status;
}

}  // namespace whittle
