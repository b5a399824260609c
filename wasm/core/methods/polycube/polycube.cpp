#include "methods/polycube/polycube.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/surface.h"

namespace whittle {

namespace {

/// Below this sine two directions are the same, or opposite.
constexpr double kSameDirection = 1e-12;

Mat3 crossMatrix(const Vec3& a) {
  Mat3 matrix;
  matrix << 0, -a.z(), a.y(), a.z(), 0, -a.x(), -a.y(), a.x(), 0;
  return matrix;
}

}  // namespace

Mat3 rotationChangeToward(const Vec3& n, const Vec3& t, double lambda) {
  const Vec3 normal = n.cross(t);
  const double sine = normal.norm(), cosine = n.dot(t);
  if (sine < kSameDirection) return Mat3::Zero();
  // In the plane of n and t the gain is 1 + cos θ + λ cos(φ − θ): greatest where tan θ = λ sin φ / (1 + λ cos φ).
  const double along = 1 + lambda * cosine, across = lambda * sine, length = std::hypot(along, across);
  if (length == 0) return Mat3::Zero();
  const Mat3 K = crossMatrix(normal / sine);
  return across / length * K + (1 - along / length) * K * K;
}

Status PolyCube::check(const PolyCubeParameters& values) const {
  if (values.directions) return {};
  return Status::failure(Code::badParameter, "a polycube needs directions; choose some, for example those of the cube");
}

std::vector<Stage> PolyCube::plan(const TriangleMesh& rest, const PolyCubeParameters& values, Stale stale) {
  return Plan(stale)
      .add(Stale::all, "measuring the mesh", 10, [this, &rest] { measure(rest); })
      .add(Stale::all, "finding where parts touch", 3, [this](double& done) { findContacts(done); })
      .add(Stale::system, "assembling the system", 3, [this, &values] { beginSystem(values.parts); })
      .add(Stale::system, "analyzing the system", 7, [this](double& done) { analyzeSystem(done); })
      // Claims what the steps work in.
      .add(Stale::system, "factoring the system", 65, [this](double& done) { return cholesky_.factorizeNext(done); })
      .add(Stale::targets, "taking the settings", 1,
           [this, &values] {
             values_ = values;
             stopping_.quantity = StoppingRule::Quantity::iterations;
             stopping_.maxIterations = values.maxIterations;
           })
      .stages();
}

void PolyCube::measure(const TriangleMesh& rest) {
  rest_ = &rest;
  components_ = connectedComponents(rest.triangles, rest.vertexCount());
  contactSearch_.reset();  // what was broken off knows another shape
  ringSmoothing_.prepare(rest.positions, rest.triangles);
  moves_.resize(rest.vertexCount(), 3);
  displacements_.resize(rest.vertexCount(), 3);
  fans_ = smoothFans(rest.positions, rest.triangles);
  fanNormals_.resize(fans_.count(), 3);
  fanAreas_.resize(fans_.count());
  previous_ = rest.positions;
}

void PolyCube::findContacts(double& done) {
  if (!contactSearch_)
    contactSearch_ = std::make_unique<ContactSearch>(*rest_, partsByEdges(rest_->triangles, rest_->vertexCount()));
  done = contactSearch_->next();
  if (done < 1) return;
  contacts_ = Attachments(contactSearch_->take());
  contactSearch_.reset();
}

void PolyCube::beginSystem(Parts parts) {
  attachments_ = parts == Parts::together ? contacts_ : Attachments();
  const Scalars areas = barycentricAreas(rest_->positions, rest_->triangles);
  gauge_.emplace(attachments_.tied(components_), std::vector<Index>{}, rest_->positions, areas);
  halfCotangents_ = halfCotangents(rest_->positions, rest_->triangles);
  laplacian_.emplace(rest_->triangles, rest_->vertexCount(), gauge_->pins());
  laplacian_->fill(halfCotangents_);
  if (attachments_.empty()) {
    cholesky_.beginAnalyze(laplacian_->lower(), {.isOrdered = true});
  } else {
    ties_ = attachments_.lower(rest_->vertexCount(), gauge_->pins());
    cholesky_.beginAnalyze(system(), {.coordinates = &rest_->positions});
  }
}

const SparseMatrix& PolyCube::system() {
  if (attachments_.empty()) return laplacian_->lower();
  tiedSystem_ = laplacian_->lower() + ties_;
  return tiedSystem_;
}

void PolyCube::analyzeSystem(double& done) {
  done = cholesky_.analyzeNext();
  if (done == 1) cholesky_.beginFactorize(system(), true);
}

void PolyCube::begin(Points& positions) {
  stopping_.begin();
  positions = rest_->positions;
}

Status PolyCube::step(Points& positions, StepReport& report) {
  if (stopping_.exhausted()) {
    report = {Outcome::iterationLimit, 0, 0};
    return {};
  }
  previous_ = positions;
  report.energy = rotateFaces(positions);
  Status status = globalStep(positions);
  if (status.ok() && !(std::isfinite(report.energy) && positions.allFinite())) {
    status = Status::failure(Code::numericalFailure,
                             "the iteration lost its numbers; the mesh may hold faces too thin to compute with");
  }
  if (!status.ok()) {
    positions = previous_;
    return status;
  }
  report.change = relativeDisplacement(positions);
  report.outcome = stopping_.judge(report);
  return {};
}

double PolyCube::rotateFaces(const Points& positions) {
  const Triangles& triangles = rest_->triangles;
  halfCotangents(positions, triangles, halfCotangents_);
  fanNormals(positions, triangles, fans_, fanNormals_, fanAreas_);
  moves_.setZero();
  double energy = 0;
  for (Index f = 0; f < triangles.rows(); ++f) {
    const auto corner = [&](int k) -> Vec3 { return positions.row(triangles(f, k)).transpose(); };
    const Vec3 edges[] = {corner(2) - corner(1), corner(0) - corner(2), corner(1) - corner(0)};
    const Vec3 vector = edges[0].cross(edges[1]), n = vector.stableNormalized();
    if (n.isZero(0)) continue;
    const Vec3 t = (*values_.directions)(aroundFace(f, n));
    const Mat3 rotationChange = rotationChangeToward(n, t, values_.lambda);
    for (int k = 0; k < 3; ++k) {
      const Vec3 force = halfCotangents_(f, k) * (rotationChange * edges[k]);
      moves_.row(triangles(f, (k + 1) % 3)) -= force.transpose();
      moves_.row(triangles(f, (k + 2) % 3)) += force.transpose();
    }
    const Vec3 rotated = n + rotationChange * n;
    energy += vector.norm() * (1 - rotated.dot(n) + values_.lambda * (1 - rotated.dot(t)));
  }
  if (attachments_.empty()) return energy;
  displacements_ = positions - rest_->positions;
  return energy + attachments_.addForces(displacements_, moves_);
}

Vec3 PolyCube::aroundFace(Index f, const Vec3& n) const {
  Vec3 sum = n;
  const Triangles& places = fans_.areVertices() ? rest_->triangles : fans_.ofCorner;
  for (int k = 0; k < 3; ++k) sum += fanNormals_.row(places(f, k)).transpose();
  return sum.isZero(0) ? n : sum;
}

Status PolyCube::globalStep(Points& positions) {
  laplacian_->fill(halfCotangents_);
  Status status = cholesky_.factorize(system(), true);
  if (!status.ok()) return status;
  for (const Index pin : gauge_->pins()) moves_.row(pin).setZero();
  cholesky_.solve(moves_);
  positions += moves_;
  if (values_.smoothing > 0) ringSmoothing_.smooth(values_.smoothing, rest_->triangles, positions);
  gauge_->restoreCentroids(positions);
  return {};
}

double PolyCube::relativeDisplacement(const Points& positions) const {
  const double move = (positions - previous_).rowwise().squaredNorm().maxCoeff();
  const double displacement = (positions - rest_->positions).rowwise().squaredNorm().maxCoeff();
  return StoppingRule::relativeDisplacement(move, displacement);
}

MethodInfo polycubeMethod() {
  using P = PolyCubeParameters;
  return methodInfo<PolyCube>("polycube", {bind("directions", &P::directions, Stale::targets, StyleKind{}),
                                           bind("lambda", &P::lambda, Stale::targets, NumberKind{{0, 100}}),
                                           bind("smoothing", &P::smoothing, Stale::targets, NumberKind{{0, 1}}),
                                           bind("parts", &P::parts, Stale::system, waysOfParts()),
                                           bind("maxIterations", &P::maxIterations, Stale::targets, kIterations)});
}

}  // namespace whittle
