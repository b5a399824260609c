#include "methods/alternating/reshape_run.h"

#include <algorithm>
#include <cmath>

#include "methods/alternating/gesture.h"
#include "methods/alternating/handle_errors.h"
#include "methods/alternating/result_remarks.h"

namespace whittle {

namespace {

/// More folded faces than this share are no result.
constexpr double kMostFlipped = 0.01;
/// What of the diagonal nobody sees, out of faces and along them.
constexpr double kUnseenMove = 1e-4, kUnseenSlide = 5e-4;
/// What of the diagonal the last fifth of a run may move.
constexpr double kLateMove = 0.0018;
/// Iterations of a dragged shape before its run from rest.
constexpr int kAnswers = 6;

std::vector<PointRow> joined(const RunRows& rows) {
  std::vector<PointRow> all = rows.handles;
  all.insert(all.end(), rows.others.begin(), rows.others.end());
  return all;
}

}  // namespace

void ReshapeRun::Attempt::setTerms(const ReshapeTerms& wanted, const std::vector<bool>& keptPatches) {
  terms = wanted;
  whittle::setTerms(terms, structure, keptPatches, surface);
  transformations.shape(surface, terms.weights);
  areTransformationsReady_ = false;
}

void ReshapeRun::Attempt::setRows(std::vector<PointRow> rows) {
  vertices.shape(surface, terms.weights, std::move(rows));
  vertices.assemble(restGoals(surface), Transformations(surface.faceCount(), Mat3::Identity()));
  vertices.beginPrepare();
  areVerticesReady_ = false;
}

Status ReshapeRun::Attempt::prepareNext(double& share) {
  constexpr double kTransformations = 0.4;  // share of the work
  Status status;
  if (!areTransformationsReady_) {
    status = transformations.prepareNext(share);
    areTransformationsReady_ = share == 1;
    share *= areVerticesReady_ ? 1 : kTransformations;
  } else if (!areVerticesReady_) {
    status = vertices.prepareNext(share);
    areVerticesReady_ = share == 1;
    share = kTransformations + (1 - kTransformations) * share;
  } else {
    share = 1;
  }
  return status;
}

void ReshapeRun::shape(const RestSurface& rest, const Structure& structure, const RunSettings& settings, RunRows rows) {
  settings_ = settings;
  rows_ = std::move(rows);
  rest_ = &rest;
  second_.reset();
  behind_.forget();
  shownTargets_.clear();
  first_ = std::make_unique<Attempt>();
  first_->surface = rest;
  first_->structure = structure;
  rung_ = Rung::full;
  keptPatches_ = findKeptPatches(structure);
  first_->setTerms(ReshapeTerms::of(settings.variant, settings.reading, rung_), keptPatches_);
  first_->setRows(joined(rows_));
}

std::vector<bool> ReshapeRun::findKeptPatches(const Structure& structure) const {
  // What a handle asks of the vertices that it is on.
  Handles moves;
  std::vector<Vec3> targets;
  for (const PointRow& handle : rows_.handles) {
    const Vec3 move = -handle.residual(rest_->mesh.positions);
    for (int i = 0; i < handle.count; ++i) {
      moves.vertices.push_back(handle.vertices[i]);
      targets.push_back(rest_->mesh.positions.row(handle.vertices[i]).transpose() + move);
    }
  }
  moves.targets.resize(static_cast<Index>(targets.size()), 3);
  for (Index i = 0; i < moves.targets.rows(); ++i) moves.targets.row(i) = targets[i].transpose();
  return keptPatches(structure.patches, rest_->mesh, moves);
}

void ReshapeRun::aim(const std::vector<Vec3>& targets) {
  targets_ = targets;
  for (std::size_t h = 0; h < targets.size(); ++h) rows_.handles[h].target = targets[h];
  aimRows(targets);
  std::vector<bool> kept = findKeptPatches(first_->structure);
  if (kept == keptPatches_) return;
  keptPatches_ = std::move(kept);
  behind_.stop();
  first_->setTerms(first_->terms, keptPatches_);
}

void ReshapeRun::limit(bool finalize, int maxIterations) {
  finalize_ = finalize;
  maxIterations_ = maxIterations;
}

AlternationLimits ReshapeRun::limits() const {
  AlternationLimits limits;
  limits.iterations = maxIterations_;
  limits.isAccelerated = isAccelerated_;
  if (isAccelerated_) limits.lateMove = kLateMove * settings_.diagonal;
  if (settings_.reading == Reading::tuned && settings_.variant == Variant::slippage) {
    limits.unseenMove = kUnseenMove * settings_.diagonal;
    limits.unseenSlide = kUnseenSlide * settings_.diagonal;
  }
  return limits;
}

void ReshapeRun::setRung(Rung rung) {
  second_.reset();
  search_.reset();
  isReady_ = false;
  if (rung == rung_) return;
  rung_ = rung;
  behind_.stop();
  first_->setTerms(ReshapeTerms::of(settings_.variant, settings_.reading, rung), keptPatches_);
}

void ReshapeRun::Attempt::forgetRuns() { areVerticesReady_ = vertices.beginRun(); }

void ReshapeRun::Attempt::begin(const AlternationLimits& limits) {
  alternation.begin(surface, terms.weights, vertices, transformations, limits);
}

void ReshapeRun::reset() {
  isDone_ = hasBest_ = false;
  isAccelerated_ = settings_.reading == Reading::tuned;
  isShowing_ = true;
  isDragged_ = false;
  answersLeft_ = 0;
  remarks_.clear();
  resumed_.reset();
  isBehindsTurn_ = false;
  aimRows(targets_);
  setRung(Rung::full);
  first_->forgetRuns();
}

void ReshapeRun::begin() {
  reset();
  behind_.stop();
  shown_ = rest_->mesh.positions;
  shownTargets_.clear();
}

void ReshapeRun::resume() {
  std::optional<Points> start = startOfGesture();
  if (!start) {
    begin();
    return;
  }
  reset();
  isDragged_ = true;
  answersLeft_ = kAnswers;
  shown_ = *start;
  resumed_ = std::move(start);
}

void ReshapeRun::aimRows(const std::vector<Vec3>& targets) {
  for (std::size_t h = 0; h < targets.size(); ++h) first_->vertices.rows()[h].target = targets[h];
}

std::vector<Vec3> ReshapeRun::movesTo(const std::vector<Vec3>& targets) const {
  std::vector<Vec3> moves;
  for (std::size_t h = 0; h < targets.size(); ++h) {
    const PointRow& handle = rows_.handles[h];
    moves.push_back(targets[h] - handle.target - handle.residual(rest_->mesh.positions));
  }
  return moves;
}

void ReshapeRun::show(const Points& positions) {
  shown_ = positions;
  shownTargets_ = targets_;
}

/// The share of an earlier gesture's displacement that this one's handles ask for: of the last one that a run from rest
/// was for, or else of what is shown.
std::optional<Points> ReshapeRun::startOfGesture() const {
  const Points& rest = rest_->mesh.positions;
  const std::vector<Vec3> now = movesTo(targets_);
  if (const auto& end = behind_.end()) {
    if (const auto times = shareOfGesture(movesTo(end->targets), now)) return rest + *times * (end->positions - rest);
  }
  if (shownTargets_.size() != targets_.size()) return std::nullopt;
  if (const auto times = shareOfGesture(movesTo(shownTargets_), now)) return rest + *times * (shown_ - rest);
  return shown_;
}

/// Makes the present attempt ready, a slice at a time.
Status ReshapeRun::prepareAttempt() {
  if (search_) {
    findSecondStructure();
    return {};
  }
  Attempt& attempt = second_ ? *second_ : *first_;
  double share = 1;
  if (Status status = attempt.prepareNext(share); !status.ok() || share < 1) return status;
  attempt.begin(limits());
  if (resumed_) attempt.alternation.resume(*resumed_);
  resumed_.reset();
  isReady_ = true;
  return {};
}

double ReshapeRun::handleError(const Points& positions) const {
  double error = 0;
  for (const PointRow& handle : rows_.handles) error = std::max(error, handle.residual(positions).norm());
  return error / settings_.diagonal;
}

Status ReshapeRun::step(StepReport& report) {
  if (isDone_) {
    report = {outcome_, 0, 0};
    return {};
  }
  report.outcome = Outcome::midway;
  if (!isReady_) {
    if (Status status = prepareAttempt(); !status.ok() || !isReady_) return status;
  }
  if (isBehindsTurn_) {
    stepBehind();
    return {};
  }
  if (isDragged_ && answersLeft_ == 0) {
    endDrag();
    return {};
  }
  Attempt& attempt = second_ ? *second_ : *first_;
  if (Status status = attempt.alternation.iterate(report); !status.ok()) return status;
  if (report.outcome == Outcome::midway) return {};
  if (!hasBest_ && isShowing_) show(attempt.alternation.positions());
  if (answersLeft_ > 0) {
    afterAnswer(report);
    return {};
  }
  if (report.outcome == Outcome::running) return {};
  outcome_ = report.outcome;
  if (Status status = finish(attempt); !status.ok()) return status;
  report.outcome = isDone_ ? outcome_ : Outcome::running;
  return {};
}

/// Gives the next step to the run behind.
void ReshapeRun::afterAnswer(StepReport& report) {
  --answersLeft_;
  if (report.outcome != Outcome::running) answersLeft_ = 0;
  report.outcome = Outcome::running;
  // The first three answers wait for one of its iterations only: so many are to come in each picture.
  if (answersLeft_ == kAnswers - 2) return;
  if (!behind_.isGoing()) {
    if (behind_.isEndOf(targets_)) return;
    behind_.begin(first_->surface, first_->terms.weights, first_->vertices, first_->transformations, limits(),
                  targets_);
  }
  aimRows(behind_.targets());
  behind_.takeUp();
  isBehindsTurn_ = true;
}

/// Does a slice of the run behind, for one iteration, or, after the last answer, until its end.
void ReshapeRun::stepBehind() {
  if (!behind_.iterate()) return;
  isBehindsTurn_ = answersLeft_ == 0 && behind_.isGoing();
  if (!isBehindsTurn_) aimRows(targets_);
}

/// Follows the last answer. What the run behind came to for other handles is a better start; for these it is shown until
/// the run from rest, which depends on nothing before it, has come as far.
void ReshapeRun::endDrag() {
  const bool isNew = behind_.hasEnded() && behind_.isEndOf(behind_.targets());
  if (isNew && behind_.targets() != targets_) {
    behind_.stop();
    resume();
    return;
  }
  if (isNew) show(behind_.end()->positions);
  reset();
  behind_.stop();
  isShowing_ = false;
}

Status ReshapeRun::finish(Attempt& attempt) {
  result_ = attempt.alternation.positions();
  if (!second_ && handleError(result_) > kMissed) {
    repeat();
    return {};
  }
  if (finalize_) {
    if (Status status = spread(attempt); !status.ok()) return status;
  }
  const FoldReport folds = findFolds(*rest_, result_);
  if (!hasBest_ || folds.isBetterThan(bestFolds_)) {
    best_ = result_;
    bestFolds_ = folds;
    hasBest_ = true;
  }
  const bool hasLadder = settings_.variant == Variant::slippage && settings_.reading == Reading::tuned;
  if (isAccelerated_ && !folds.isClean()) {
    // What is shortened much folds at the end of its way, where acceleration leads, and not yet on it.
    isAccelerated_ = false;
    setRung(rung_);
    return {};
  }
  if (hasLadder && !folds.isClean() && rung_ != Rung::none) {
    setRung(static_cast<Rung>(static_cast<int>(rung_) + 1));
    return {};
  }
  isDone_ = true;
  show(best_);
  behind_.note({targets_, best_});
  return judge();
}

Status ReshapeRun::judge() {
  if (bestFolds_.flipped > kMostFlipped * rest_->faceCount()) {
    return Status::failure(Code::badHandles,
                           "this gesture turns the shape inside out: " + std::to_string(bestFolds_.flipped) +
                               " of its " + std::to_string(rest_->faceCount()) +
                               " faces fold over; move the handles less far");
  }
  const bool keepsSizes = settings_.variant == Variant::slippage && settings_.reading == Reading::tuned;
  remarks_ = resultRemarks(
      {*rest_, first_->structure, keptPatches_, rows_.handles, best_, bestFolds_, handleError(best_), keepsSizes});
  return {};
}

void ReshapeRun::repeat() {
  second_ = std::make_unique<Attempt>();
  second_->surface = measureSurface({result_, rest_->mesh.triangles});
  search_ = std::make_unique<StructureSearch>(second_->surface, settings_.features);
  isReady_ = false;
}

/// The parts that keep their radius are those of the first run.
void ReshapeRun::findSecondStructure() {
  if (search_->next() < 1) return;
  second_->structure = search_->take();
  search_.reset();
  second_->structure.patches = first_->structure.patches;
  second_->setTerms(first_->terms, keptPatches_);
  second_->setRows(joined(rows_));
}

Status ReshapeRun::spread(Attempt& attempt) {
  Points finalized = result_;
  bool isSpread = false;
  Status status = spreadHandleErrors(attempt.surface, attempt.terms.weights, attempt.alternation.transformations(),
                                     attempt.vertices.rows(), static_cast<Index>(rows_.handles.size()),
                                     attempt.terms.weakHandles, finalized, isSpread);
  if (!status.ok() || !isSpread) return status;
  // What is spread must cost neither a handle nor a face.
  const bool missesMore = handleError(finalized) > kMissed && handleError(result_) <= kMissed;
  const bool foldsMore = findFolds(*rest_, finalized).flipped > findFolds(*rest_, result_).flipped;
  if (settings_.reading == Reading::tuned && (missesMore || foldsMore)) return {};
  result_ = finalized;
  return {};
}

}  // namespace whittle
