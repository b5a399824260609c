#include "methods/plastic/plastic.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "methods/plastic/held_points.h"

namespace whittle {

namespace {

/// Rounding of a target that is where its vertex is.
constexpr double kNoMove = 1e-9;
/// Targets farther away than so many times the longest side are a mistake.
constexpr double kFarthest = 1e3;
/// While the rest is held, growth that reaches farther swells all of the shape.
constexpr double kFarthestReach = 0.2;
/// A radius from which on growth reaches everywhere.
constexpr double kEverywhere = 1;
/// Landmarks that are too many for growth without limit.
constexpr std::size_t kFewLandmarks = 4;
/// A landmark that is missed by more, in a shape that is 100 long, is said to be missed.
constexpr double kMissed = 0.1;
/// Stretch between landmarks from which on faces are drawn out too far to carry it.
constexpr double kMostStretch = 4;

}  // namespace

Status Plastic::check(const PlasticParameters& values) const {
  for (Index l = 0; l < values.landmarks.targets.rows(); ++l) {
    if (values.landmarks.targets.row(l).norm() < kFarthest) continue;
    return Status::failure(
        Code::badHandles,
        "the target of vertex {} is more than a thousand times as far away as the shape is long; are "
        "its units those of the file?",
        Element::vertex(values.landmarks.vertices[l]));
  }
  return {};
}

std::vector<Stage> Plastic::plan(const TriangleMesh& rest, const PlasticParameters& values, Stale stale) {
  rest_ = &rest;
  Plan plan(stale);
  plan.add(Stale::all, "measuring the mesh", 5, [this] { findSurface(); })
      .add(Stale::all, "finding the way back", 5, [this](double& done) { done = transfer_->next(); })
      .add(Stale::system, "measuring the shell", 10, [this, &values] { shape(values); })
      .add(Stale::system, "factoring the system", 40, [this](double& done) { return run_.prepareNext(done); })
      .add(Stale::targets, "taking the landmarks", 2, [this, &values] { aim(values); })
      .add(Stale::targets, "holding the landmarks", 2, [this](double& done) { return run_.prepareNext(done); });
  return plan.stages();
}

void Plastic::findSurface() {
  working_ = clean(*rest_);
  transfer_.emplace(*rest_, working_.derived);
}

bool Plastic::carries(Index vertex) const {
  const Transfer::Place& place = transfer_->place(vertex);
  return place.twin >= 0 || place.face >= 0;
}

bool Plastic::isFixed(const Handles& landmarks, std::size_t which) const {
  const Index l = static_cast<Index>(which);
  return (landmarks.targets.row(l) - rest_->positions.row(landmarks.vertices[which])).norm() < kNoMove;
}

LandmarkSet Plastic::landmarksOf(const PlasticParameters& values) const {
  LandmarkSet set;
  const TriangleMesh& mesh = working_.derived.mesh;
  for (std::size_t l = 0; l < values.landmarks.vertices.size(); ++l) {
    const Index vertex = values.landmarks.vertices[l];
    if (!carries(vertex)) continue;
    const Transfer::Place& place = transfer_->place(vertex);
    if (place.twin >= 0 && shapedFixed_[l]) {
      set.fixed.push_back(place.twin);
      continue;
    }
    Landmark landmark;
    if (place.twin >= 0) {
      landmark.vertices[0] = place.twin;
      landmark.weights[0] = 1;
    } else {
      for (int k = 0; k < 3; ++k) landmark.vertices[k] = mesh.triangles(place.face, k);
      landmark.weights = place.weights;
    }
    // The vertex keeps its distance from the point of the working mesh that it follows.
    const Vec3 offset = rest_->positions.row(vertex).transpose() - landmark.at(mesh.positions);
    landmark.target = values.landmarks.targets.row(static_cast<Index>(l)).transpose() - offset;
    set.moved.push_back(landmark);
  }
  return set;
}

PlasticSettings Plastic::settingsOf(const PlasticParameters& values) const {
  PlasticSettings settings;
  settings.alpha = values.alpha;
  settings.thickness = values.thickness;
  settings.poisson = values.poisson;
  settings.resetsRest = values.resetRest;
  settings.aligns = values.align;
  settings.turn = values.turn * std::acos(-1.0) / 180;
  settings.maxIterations = values.maxIterations;
  settings.beta = values.beta;
  settings.isByRadius = values.beta == 0 && values.radius < kEverywhere;
  settings.radius = values.radius;
  return settings;
}

void Plastic::shape(const PlasticParameters& values) {
  shapedFixed_.clear();
  std::vector<Vec3> held;
  for (std::size_t l = 0; l < values.landmarks.vertices.size(); ++l) {
    shapedFixed_.push_back(isFixed(values.landmarks, l));
    if (shapedFixed_.back()) held.emplace_back(rest_->positions.row(values.landmarks.vertices[l]).transpose());
  }
  PlasticSettings settings = settingsOf(values);
  const HeldPoints::Rank rank = HeldPoints(held).rank;
  const bool isLoose = rank == HeldPoints::Rank::none || rank == HeldPoints::Rank::point;
  const bool mayGrow = isLoose && values.landmarks.vertices.size() <= kFewLandmarks;
  isRadiusCapped_ = values.beta == 0 && values.radius > kFarthestReach && !mayGrow;
  if (isRadiusCapped_) {
    settings.isByRadius = true;
    settings.radius = kFarthestReach;
  }
  run_.shape(working_.derived.mesh, landmarksOf(values), settings);
}

void Plastic::aim(const PlasticParameters& values) {
  landmarks_ = values.landmarks;
  bool areSame = true;
  for (std::size_t l = 0; l < shapedFixed_.size(); ++l) areSame = areSame && shapedFixed_[l] == isFixed(landmarks_, l);
  if (!areSame) {
    shape(values);
    return;
  }
  std::vector<Vec3> targets;
  for (const Landmark& landmark : landmarksOf(values).moved) targets.push_back(landmark.target);
  run_.aim(targets, values.maxIterations);
}

void Plastic::begin(Points&) { run_.begin(); }

Status Plastic::step(Points& positions, StepReport& report) {
  if (Status status = run_.step(report); !status.ok()) return status;
  if (report.outcome == Outcome::midway) return {};
  transfer_->carry(run_.positions(), positions);
  for (std::size_t l = 0; l < landmarks_.vertices.size(); ++l) {
    if (!carries(landmarks_.vertices[l]))
      positions.row(landmarks_.vertices[l]) = landmarks_.targets.row(static_cast<Index>(l));
  }
  return {};
}

std::vector<std::string> Plastic::warnings(const PlasticParameters& values) const {
  std::vector<std::string> remarks;
  if (values.landmarks.vertices.empty())
    return {"There are no landmarks, so nothing moves: hold some vertices and pull others."};
  if (isRadiusCapped_)
    remarks.push_back("While much is held the radius is taken as 0.2; farther growth would swell all of the shape.");
  char text[200];
  if (const double stretch = run_.demandedStretch(); stretch > kMostStretch) {
    std::snprintf(
        text, sizeof text,
        "Two landmarks are to be %.1f times as far apart as they are; where that is more than four times, faces "
        "may be drawn out or pass through each other: add landmarks, or pull less far.",
        stretch);
    remarks.push_back(text);
  }
  if (const double error = run_.largestError(); error > kMissed) {
    std::snprintf(text, sizeof text, "A landmark is missed by %.1f %% of the shape's length: %s.", error,
                  run_.isAtLimit() ? "the run came to its limit of iterations, and more may bring it nearer"
                                   : "what the landmarks ask for does not go together with the shape");
    remarks.push_back(text);
  }
  return remarks;
}

MethodInfo plasticMethod() {
  using P = PlasticParameters;
  return methodInfo<Plastic>("plastic", {bind("landmarks", &P::landmarks, Stale::system, HandlesKind{}),
                                         bind("radius", &P::radius, Stale::system, NumberKind{{0.02, 1}}),
                                         bind("beta", &P::beta, Stale::system, NumberKind{{0, 1e6}}),
                                         bind("alpha", &P::alpha, Stale::system, NumberKind{{1e-3, 1e6}}),
                                         bind("thickness", &P::thickness, Stale::system, NumberKind{{0.1, 100}}),
                                         bind("poisson", &P::poisson, Stale::system, NumberKind{{0, 0.49}}),
                                         bind("resetRest", &P::resetRest, Stale::system, FlagKind{}),
                                         bind("align", &P::align, Stale::system, FlagKind{}),
                                         bind("turn", &P::turn, Stale::system, NumberKind{{0, 3600}}),
                                         bind("maxIterations", &P::maxIterations, Stale::targets, kIterations)});
}

}  // namespace whittle
