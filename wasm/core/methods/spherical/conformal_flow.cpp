#include "methods/spherical/conformal_flow.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "geometry/cotangent.h"
#include "geometry/surface.h"
#include "methods/spherical/moebius.h"
#include "methods/spherical/sphere_topology.h"

namespace whittle {

namespace {

/// How τ grows with each step, and how far. The path to the sphere is decided early; the long way of the rounder
/// surface bears longer steps. The same sphere to within the mesh's own error, in a quarter of the steps.
constexpr double kGrowth = 1.1;
constexpr double kMostGrowth = 10;
/// Dirichlet energy over area from which the end of the flow is no sphere but a needle. On the way, long shapes reach
/// some hundreds and come back; from more there is no return. That happens where lumped areas cannot tell a sphere from
/// an ellipsoid: eight corners of a cube, or very uneven triangles.
constexpr double kNeedle = 2;
constexpr double kNoReturn = 1e4;

/// Inputs of fewer vertices are refined to at least so many.
constexpr Index kFew = 500, kEnough = 1500;
/// Times the input's diagonal that a surface may have which the iteration limit leaves on its way.
constexpr double kLargest = 2;

double squaredDiagonal(const Points& positions) {
  return (positions.colwise().maxCoeff() - positions.colwise().minCoeff()).squaredNorm();
}

Status lost(const std::string& how) {
  return Status::failure(
      Code::numericalFailure,
      "the flow to the sphere " + how + "; subdivide the mesh or remesh it more evenly, or lower timeStep");
}

Status requireUnfolded(const Triangles& triangles, const Points& positions, const Vec3& center) {
  const Index folded = countFolded(triangles, positions, center);
  return folded == 0 ? Status{}
                     : lost("folded " + std::to_string(folded) + (folded == 1 ? " face over" : " faces over"));
}

Vec3 areaCentroid(const Points& positions, const Scalars& areas) { return positions.transpose() * areas / areas.sum(); }

}  // namespace

std::vector<Stage> ConformalFlow::plan(const TriangleMesh& rest, const SphericalParameters& values, Stale stale) {
  return Plan(stale)
      .add(Stale::all, "measuring the mesh", 8, [this, &rest] { measure(rest); })
      .add(Stale::all, "analyzing the system", 8, [this](double& done) { done = cholesky_.analyzeNext(); })
      .add(Stale::targets, "taking the settings", 1, [this, &values] { values_ = values; })
      .stages();
}

void ConformalFlow::measure(const TriangleMesh& input) {
  input_ = rest_ = &input;
  refinement_.reset();
  if (input.vertexCount() < kFew) {
    rest_ = &refinement_.emplace(input, kEnough).mesh();
    surface_.resize(rest_->vertexCount(), 3);
  }
  areas_ = barycentricAreas(rest_->positions, rest_->triangles);
  restArea_ = areas_.sum();
  restCentroid_ = areaCentroid(rest_->positions, areas_);
  const CornerScalars cotangents = halfCotangents(rest_->positions, rest_->triangles);
  laplacian_ = cotangentLaplacian(rest_->triangles, cotangents, rest_->vertexCount());
  system_ = laplacian_;
  cholesky_.beginAnalyze(system_, {.isOrdered = !refinement_.has_value()});
  for (auto* points : {&gradient_, &correction_, &previous_}) points->resize(rest_->vertexCount(), 3);
}

void ConformalFlow::begin(Points& positions) {
  iterations_ = 0;
  if (refinement_) refinement_->spread(positions, surface_);
}

Status ConformalFlow::step(Points& positions, StepReport& report) {
  if (!refinement_) return stepSurface(positions, report);
  Status status = stepSurface(surface_, report);
  if (!status.ok()) return status;
  Points result = surface_.topRows(positions.rows());
  if (report.outcome == Outcome::converged) status = requireUnfolded(input_->triangles, result, restCentroid_);
  if (status.ok()) positions = std::move(result);
  return status;
}

bool ConformalFlow::isDrawnOut(const Points& positions) const {
  return squaredDiagonal(positions) > kLargest * kLargest * squaredDiagonal(rest_->positions);
}

Status ConformalFlow::stepSurface(Points& positions, StepReport& report) {
  if (iterations_ >= values_.maxIterations) {
    report = {Outcome::iterationLimit, 0, 0};
    return {};
  }
  previous_ = positions;
  areas_ = barycentricAreas(positions, rest_->triangles);
  const double area = areas_.sum();
  gradient_.noalias() = laplacian_.selfadjointView<Eigen::Lower>() * positions;
  report.energy = 0.5 * gradient_.cwiseProduct(positions).sum() / area;
  Status status = report.energy < kNoReturn ? flow(positions, area) : lost("drew the surface out to a needle");
  if (status.ok()) {
    report.change = meanSquaredMove(positions, area);
    ++iterations_;
    report.outcome = report.change <= values_.tolerance     ? Outcome::converged
                     : iterations_ >= values_.maxIterations ? Outcome::iterationLimit
                                                            : Outcome::running;
    if (report.outcome == Outcome::converged)
      status = report.energy < kNeedle ? project(positions) : lost("ended as a needle");
    if (report.outcome == Outcome::iterationLimit && isDrawnOut(positions))
      status = lost("drew the surface out to a needle");
  }
  if (!status.ok()) positions = previous_;
  return status;
}

double ConformalFlow::timeStep() const {
  return values_.timeStep * std::min(kMostGrowth, std::pow(kGrowth, iterations_));
}

Status ConformalFlow::flow(Points& positions, double area) {
  const double tau = timeStep() * area;
  system_.coeffs() = tau * laplacian_.coeffs();
  // Sorted columns of a lower triangle begin with the diagonal. A vertex without a face has no area and stays.
  for (Index v = 0; v < areas_.size(); ++v)
    system_.valuePtr()[system_.outerIndexPtr()[v]] += areas_[v] > 0 ? areas_[v] : 1;
  Status status = cholesky_.factorize(system_);
  if (!status.ok()) return status;
  correction_ = -tau * gradient_;
  cholesky_.solve(correction_);
  positions += correction_;
  restoreFrame(positions);
  return positions.allFinite() ? Status{} : lost("lost its numbers");
}

void ConformalFlow::restoreFrame(Points& positions) const {
  const Scalars areas = barycentricAreas(positions, rest_->triangles);
  const Vec3 centroid = areaCentroid(positions, areas);
  const double scale = std::sqrt(restArea_ / areas.sum());
  for (Index v = 0; v < positions.rows(); ++v) {
    if (areas_[v] == 0) continue;
    positions.row(v) = restCentroid_.transpose() + scale * (positions.row(v) - centroid.transpose());
  }
}

double ConformalFlow::meanSquaredMove(const Points& positions, double area) {
  correction_ = (positions - previous_) / std::sqrt(area);
  gradient_ = (previous_.rowwise() - restCentroid_.transpose()).rowwise().normalized();
  return meanSquareButBoost(areas_, gradient_, correction_);
}

Status ConformalFlow::project(Points& positions) const {
  Points directions = (positions.rowwise() - restCentroid_.transpose()).rowwise().normalized();
  const Scalars weights = barycentricAreas(rest_->positions, rest_->triangles);
  balanceOnSphere(weights, directions);
  const double radius = std::sqrt(restArea_ / (4 * EIGEN_PI));
  for (Index v = 0; v < positions.rows(); ++v) {
    if (weights[v] > 0) positions.row(v) = restCentroid_.transpose() + radius * directions.row(v);
  }
  return requireUnfolded(rest_->triangles, positions, restCentroid_);
}

MethodInfo sphericalMethod() {
  using P = SphericalParameters;
  return methodInfo<ConformalFlow>("spherical",
                                   {bind("timeStep", &P::timeStep, Stale::targets, NumberKind{{1e-6, 1}}),
                                    bind("tolerance", &P::tolerance, Stale::targets, NumberKind{{0, 1}}),
                                    bind("maxIterations", &P::maxIterations, Stale::targets, kIterations)},
                                   requireSphere);
}

}  // namespace whittle
