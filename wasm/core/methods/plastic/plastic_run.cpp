#include "methods/plastic/plastic_run.h"

#include <algorithm>
#include <cmath>

#include "geometry/surface.h"
#include "methods/plastic/alignment.h"

namespace whittle {

namespace {

/// How long every shape is for what runs here.
constexpr double kLength = 100;
/// A landmark that is nearer to its target is there.
constexpr double kMet = 0.01;
/// A step that promises a smaller share of what is left is not worth it.
constexpr double kWorth = 1e-3;
/// The farthest that a step turns a face, and the largest share of its stretch by which it changes that.
constexpr double kFarthestTurn = 0.4, kFarthestStretch = 0.3;
constexpr int kHalvings = 8;
/// When a leg of a way is done: how near landmarks have come, or iterations.
constexpr double kLegMet = 0.5;
constexpr int kLegIterations = 6;

double smallerStretch(const Mat2& S) { return (S.trace() - std::hypot(S(0, 0) - S(1, 1), 2 * S(0, 1))) / 2; }

}  // namespace

void PlasticRun::shape(const TriangleMesh& mesh, const LandmarkSet& landmarks, const PlasticSettings& settings) {
  settings_ = settings;
  input_ = mesh.positions;
  shown_ = input_;
  takeActiveParts(mesh, landmarks);
  isAnalyzed_ = false;
  phase_ = Phase::done;
  if (landmarks_.empty()) return;
  shell_.setRest(active_, {settings.thickness, settings.poisson});
  system_.shape(shell_, nodeOf_);
  const double reach = meanSide(shell_) / (2 * settings.radius * kLength);
  prior_.shape(shell_, settings.alpha,
               settings.isByRadius ? settings.alpha * reach * reach * reach * reach : settings.beta);
}

/// Takes the parts that a landmark is to move, at their length of 100.
void PlasticRun::takeActiveParts(const TriangleMesh& mesh, const LandmarkSet& landmarks) {
  const Components parts = connectedComponents(mesh.triangles, mesh.vertexCount());
  std::vector<bool> isMoved(parts.count, false);
  for (const Landmark& landmark : landmarks.moved) isMoved[parts.ofVertex[landmark.vertices[0]]] = true;
  std::vector<Index> placeOf(mesh.vertexCount(), -1);
  vertices_.clear();
  for (Index v = 0; v < mesh.vertexCount(); ++v) {
    if (!isMoved[parts.ofVertex[v]]) continue;
    placeOf[v] = static_cast<Index>(vertices_.size());
    vertices_.push_back(v);
  }

  const Scalars areas = barycentricAreas(mesh.positions, mesh.triangles);
  center_ = (mesh.positions.transpose() * areas) / areas.sum();
  const Points arms = mesh.positions.rowwise() - center_.transpose();
  scale_ = kLength / std::sqrt(12 * arms.rowwise().squaredNorm().dot(areas) / areas.sum());
  active_.positions.resize(static_cast<Index>(vertices_.size()), 3);
  for (std::size_t i = 0; i < vertices_.size(); ++i)
    active_.positions.row(static_cast<Index>(i)) = scale_ * arms.row(vertices_[i]);
  std::vector<Index> faces;
  for (Index f = 0; f < mesh.faceCount(); ++f) {
    if (placeOf[mesh.triangles(f, 0)] >= 0) faces.push_back(f);
  }
  active_.triangles.resize(static_cast<Index>(faces.size()), 3);
  for (std::size_t i = 0; i < faces.size(); ++i) {
    for (int k = 0; k < 3; ++k) active_.triangles(static_cast<Index>(i), k) = placeOf[mesh.triangles(faces[i], k)];
  }

  nodeOf_.assign(vertices_.size(), 0);
  for (const Index v : landmarks.fixed) {
    if (placeOf[v] >= 0) nodeOf_[placeOf[v]] = -1;
  }
  Index nodes = 0;
  for (Index& node : nodeOf_) node = node < 0 ? -1 : nodes++;
  landmarks_ = landmarks.moved;
  targets_.clear();
  for (Landmark& landmark : landmarks_) {
    for (Index& v : landmark.vertices) v = v < 0 ? -1 : placeOf[v];
    targets_.push_back(scale_ * (landmark.target - center_));
  }
  parts_ = connectedComponents(active_.triangles, active_.vertexCount());
}

Status PlasticRun::prepareNext(double& share) {
  constexpr double kSystem = 0.5;  // share of the work
  if (landmarks_.empty()) {
    share = 1;
    return {};
  }
  if (!isAnalyzed_) {
    const double done = system_.analyzeNext();
    isAnalyzed_ = done == 1;
    share = kSystem * done;
    return {};
  }
  const Status status = prior_.prepareNext(share);
  if (share < 1) share = kSystem + (1 - kSystem) * share;
  return status;
}

void PlasticRun::aim(const std::vector<Vec3>& targets, int maxIterations) {
  settings_.maxIterations = maxIterations;
  for (std::size_t l = 0; l < targets.size(); ++l) targets_[l] = scale_ * (targets[l] - center_);
}

void PlasticRun::begin() {
  shown_ = input_;
  iterations_ = 0;
  phase_ = Phase::done;
  outcome_ = Outcome::converged;
  if (landmarks_.empty()) return;
  positions_ = active_.positions;
  if (settings_.aligns) align();
  findPath();
  shell_.setRestPositions(positions_);
  field_ = PlasticField::identity(shell_.faceCount());
  change_.setZero(6 * shell_.faceCount());
  phase_ = Phase::start;
}

void PlasticRun::align() {
  for (Index part = 0; part < parts_.count; ++part) {
    std::vector<Vec3> held, points, targets;
    for (Index v = 0; v < active_.vertexCount(); ++v) {
      if (parts_.ofVertex[v] == part && nodeOf_[v] < 0) held.emplace_back(positions_.row(v).transpose());
    }
    for (const Landmark& landmark : landmarks_) {
      if (parts_.ofVertex[landmark.vertices[0]] != part) continue;
      points.push_back(landmark.at(positions_));
      targets.push_back(targets_[&landmark - landmarks_.data()]);
    }
    const RigidMotion motion = alignment(held, points, targets);
    for (Index v = 0; v < active_.vertexCount(); ++v) {
      if (parts_.ofVertex[v] == part && nodeOf_[v] >= 0)
        positions_.row(v) = motion(positions_.row(v).transpose()).transpose();
    }
  }
}

/// The way to the targets: of one part, against what is held of it.
void PlasticRun::findPath() {
  std::vector<Vec3> points;
  for (const Landmark& landmark : landmarks_) points.push_back(landmark.at(positions_));
  const bool isHeld = std::find(nodeOf_.begin(), nodeOf_.end(), -1) != nodeOf_.end();
  path_ = isHeld && parts_.count == 1 ? TurnPath(points, targets_, settings_.turn) : TurnPath();
  leg_ = 0;
  goOn();
}

void PlasticRun::goOn() {
  ++leg_;
  iterationsOfLeg_ = 0;
  for (std::size_t l = 0; l < landmarks_.size(); ++l)
    landmarks_[l].target = leg_ < path_.legs() ? path_.target(l, leg_) : targets_[l];
}

double PlasticRun::squaredErrors(const Points& positions) const {
  double sum = 0;
  for (const Landmark& landmark : landmarks_) sum += (landmark.at(positions) - landmark.target).squaredNorm();
  return sum;
}

double PlasticRun::meanError() const {
  double sum = 0;
  for (const Landmark& landmark : landmarks_) sum += (landmark.at(positions_) - landmark.target).norm();
  return landmarks_.empty() ? 0 : sum / static_cast<double>(landmarks_.size());
}

double PlasticRun::largestError() const {
  double largest = 0;
  for (std::size_t l = 0; l < landmarks_.size(); ++l)
    largest = std::max(largest, (landmarks_[l].at(positions_) - targets_[l]).norm());
  return largest;
}

double PlasticRun::demandedStretch() const {
  double most = 0;
  const auto compare = [&](const Vec3& from, const Vec3& to, const Vec3& otherFrom, const Vec3& otherTo) {
    const double apart = (from - otherFrom).norm();
    if (apart > 0) most = std::max(most, (to - otherTo).norm() / apart);
  };
  for (std::size_t l = 0; l < landmarks_.size(); ++l) {
    const Vec3 from = landmarks_[l].at(active_.positions);
    for (std::size_t other = 0; other < l; ++other)
      compare(from, targets_[l], landmarks_[other].at(active_.positions), targets_[other]);
    for (Index v = 0; v < active_.vertexCount(); ++v) {
      if (nodeOf_[v] >= 0 || parts_.ofVertex[v] != parts_.ofVertex[landmarks_[l].vertices[0]]) continue;
      const Vec3 held = active_.positions.row(v).transpose();
      compare(from, targets_[l], held, held);
    }
  }
  return most;
}

Status PlasticRun::step(StepReport& report) {
  report = {Outcome::midway, 0, 0};
  Status status;
  switch (phase_) {
    case Phase::start: beginIteration(report); break;
    case Phase::assemble:
      modes_.find(positions_, parts_, nodeOf_);
      system_.beginFactorize(shell_, modes_);
      phase_ = Phase::factor;
      break;
    case Phase::factor: {
      double share = 0;
      status = system_.factorizeNext(share);
      if (share < 1 || !status.ok()) break;
      direction_.begin({shell_, modes_, landmarks_, change_}, system_, prior_);
      phase_ = Phase::direction;
      break;
    }
    case Phase::direction: {
      bool isDone = false;
      status = direction_.next(isDone);
      if (!isDone || !status.ok()) break;
      const double promised = objective_ - direction_.model();
      const double floor = objective_ + static_cast<double>(landmarks_.size()) * kMet * kMet;
      if (promised < kWorth * floor) {
        endLeg(Outcome::converged, report);
        break;
      }
      share_ = longestShare(direction_.change());
      halvings_ = 0;
      beginTrial();
      break;
    }
    case Phase::trial:
      status = equilibrium_.next();
      if (status.ok() && equilibrium_.end() != Equilibrium::End::none) judgeTrial(report);
      break;
    case Phase::done: report = {outcome_, objective_, 0}; break;
  }
  return status;
}

void PlasticRun::beginIteration(StepReport& report) {
  if (settings_.resetsRest) {
    shell_.setRestPositions(positions_);
    field_ = PlasticField::identity(shell_.faceCount());
    change_.setZero();
  } else {
    shell_.setPlastic(field_);
    shell_.setShape(positions_);
  }
  objective_ = squaredErrors(positions_) + prior_.energy(change_);
  if (iterations_ == 0) {
    if (leg_ == path_.legs() && meanError() < kMet) finish(Outcome::converged);
    if (settings_.maxIterations == 0) finish(Outcome::iterationLimit);
  }
  if (phase_ == Phase::done) {
    show();
    report = {outcome_, objective_, 0};
    return;
  }
  phase_ = Phase::assemble;
}

/// The share of a change that neither turns nor stretches a face too far at once.
double PlasticRun::longestShare(const Scalars& change) const {
  double share = 1;
  for (Index f = 0; f < shell_.faceCount(); ++f) {
    const double turn = change.segment<3>(3 * f).norm();
    const double stretch = stretchNumbers(change, shell_.faceCount(), f).norm();
    if (turn * share > kFarthestTurn) share = kFarthestTurn / turn;
    const double most = kFarthestStretch * smallerStretch(field_.stretches[f]);
    if (stretch * share > most) share = most / stretch;
  }
  return share;
}

void PlasticRun::beginTrial() {
  trialField_ = field_;
  trialField_.add(direction_.change(), share_);
  Points start = positions_ + share_ * direction_.move();
  modes_.move(direction_.rigid(), share_, start);
  shell_.setPlastic(trialField_);
  equilibrium_.begin(shell_, system_, modes_, start, {});
  phase_ = Phase::trial;
  if (equilibrium_.end() == Equilibrium::End::none) return;
  StepReport unread;
  judgeTrial(unread);
}

void PlasticRun::judgeTrial(StepReport& report) {
  const Scalars change = change_ + share_ * direction_.change();
  const double objective = squaredErrors(equilibrium_.positions()) + prior_.energy(change);
  if (equilibrium_.end() != Equilibrium::End::pressed && objective < objective_) {
    change_ = change;
    accept(report);
    return;
  }
  if (++halvings_ <= kHalvings) {
    share_ /= 2;
    beginTrial();
    return;
  }
  endLeg(Outcome::stalled, report);
}

/// Turns to the next leg where a step of this one gets no nearer; after the last the run ends.
void PlasticRun::endLeg(Outcome outcome, StepReport& report) {
  if (leg_ < path_.legs()) {
    goOn();
    phase_ = Phase::start;
    return;
  }
  finish(outcome);
  report = {outcome_, objective_, 0};
}

void PlasticRun::accept(StepReport& report) {
  const double move = (equilibrium_.positions() - positions_).rowwise().norm().maxCoeff();
  const double all = (equilibrium_.positions() - active_.positions).rowwise().norm().maxCoeff();
  field_ = trialField_;
  positions_ = equilibrium_.positions();
  ++iterations_;
  ++iterationsOfLeg_;
  show();
  report = {Outcome::running, objective_, all > 0 ? move / all : 0};
  if (leg_ < path_.legs() && (meanError() < kLegMet || iterationsOfLeg_ >= kLegIterations)) {
    goOn();
  } else if (leg_ == path_.legs() && meanError() < kMet) {
    finish(Outcome::converged);
  }
  if (phase_ != Phase::done && iterations_ >= settings_.maxIterations) {
    finish(Outcome::iterationLimit);
  }
  if (phase_ == Phase::done) {
    report.outcome = outcome_;
    return;
  }
  phase_ = Phase::start;
}

void PlasticRun::finish(Outcome outcome) {
  phase_ = Phase::done;
  outcome_ = outcome;
}

void PlasticRun::show() {
  shown_ = input_;
  for (std::size_t i = 0; i < vertices_.size(); ++i) {
    if (nodeOf_[i] < 0) continue;
    shown_.row(vertices_[i]) = positions_.row(static_cast<Index>(i)) / scale_ + center_.transpose();
  }
}

}  // namespace whittle
