#include "methods/local_global/local_global.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/rotation_fit.h"
#include "geometry/surface.h"

namespace whittle {

namespace {

/// Share of the energy that the regularizers' single precision decides.
constexpr double kRounding = 1e-7;

/// Elements that go through the local step together: as many as the nearest cache holds all of.
constexpr Index kBlock = 64;

const std::vector<Lanes> kNoGrowths;

enum SharedParameter { kHandles, kAcceleration, kStopOn, kTolerance };

ParameterInfo maxIterationsParameter(int usual) {
  return {"maxIterations", ParameterKind::integer, Stale::targets, static_cast<double>(usual), 0, 1e6};
}

}  // namespace

std::vector<ParameterInfo> withSharedParameters(std::vector<ParameterInfo> own) {
  own.push_back({"handles", ParameterKind::handles, Stale::system});
  own.push_back(Acceleration::parameter());
  own.push_back(StoppingRule::parameter());
  own.push_back({"tolerance", ParameterKind::number, Stale::targets, 3e-3, 0, 1});
  own.push_back(maxIterationsParameter(1000));
  return own;
}

std::vector<ParameterInfo> withIterations(std::vector<ParameterInfo> own, int usual) {
  own.push_back({"handles", ParameterKind::handles, Stale::system});
  own.push_back(maxIterationsParameter(usual));
  return own;
}

Status LocalGlobal::prepare(const TriangleMesh& rest, const Settings& settings, Stale stale) {
  if (stale == Stale::nothing) return {};
  takeEnding(settings);
  handles_.targets = settings.handles.targets;
  if (stale >= Stale::all) prepareRestShape(rest, localStep_->rigidity(settings));
  if (stale >= Stale::weights) {
    if (Status status = localStep_->prepare(*rest_, settings); !status.ok()) return status;
    if (scales_) scales_->prepare(*edges_, rest_->mesh.positions, localStep_->pullWeights());
  }
  if (stale < Stale::system) return {};
  Status status = prepareSystem(settings.handles);
  if (status.ok() && stale >= Stale::all) claimRunningState();  // late: the factorization's memory is the peak
  return status;
}

void LocalGlobal::takeEnding(const Settings& settings) {
  stopping_.maxIterations = static_cast<int>(settings.numbers.back());
  if (ending_ == Ending::iterations) {
    stopping_.quantity = StoppingRule::Quantity::iterations;
    return;
  }
  const double* shared = settings.numbers.data() + ownParameters_;
  accelerationKind_ = static_cast<Acceleration::Kind>(shared[kAcceleration]);
  stopping_.quantity = static_cast<StoppingRule::Quantity>(shared[kStopOn]);
  stopping_.tolerance = shared[kTolerance];
}

void LocalGlobal::prepareRestShape(const TriangleMesh& rest, Rigidity rigidity) {
  rest_.emplace(RestShape{rest, barycentricAreas(rest.positions, rest.triangles), vertexNormals(rest.positions, rest.triangles)});
  halfCotangents_ = halfCotangents(rest.positions, rest.triangles);
  edges_ = makeEdgeSet(edgeSetOf(rigidity), rest, halfCotangents_);
  scales_.reset();
  if (rigidity == Rigidity::acap) scales_.emplace(edges_->elementCount());
  components_ = connectedComponents(rest.triangles, rest.vertexCount());
  eliminationOrder_.clear();
}

void LocalGlobal::claimRunningState() {
  const Index vertexCount = rest_->mesh.vertexCount();
  for (auto* rotations : {&guess_, &rotations_}) rotations->assign(batchCount(edges_->elementCount()), identityRotations());
  covariances_.resize(batchCount(kBlock));
  residual_.resize(vertexCount);
  previous_.resize(vertexCount, 3);
  acceleration_.resize(vertexCount);
}

Status LocalGlobal::prepareSystem(const Handles& handles) {
  handles_ = handles;
  gauge_.emplace(components_, handles.vertices, rest_->mesh.positions, rest_->areas);
  std::vector<Index> held = handles.vertices;
  held.insert(held.end(), gauge_->pins().begin(), gauge_->pins().end());
  const TriangleMesh& mesh = rest_->mesh;
  SparseMatrix L = cotangentLaplacian(mesh.triangles, halfCotangents_, mesh.vertexCount());
  if (eliminationOrder_.empty()) eliminationOrder_ = eliminationOrder(graphOf(L), &mesh.positions);
  return system_.prepare(std::move(L), held, {.order = &eliminationOrder_});
}

void LocalGlobal::begin(Points& positions) {
  stopping_.begin();
  acceleration_.begin(localStep_->followsOutput() ? Acceleration::Kind::none : accelerationKind_);
  energy_ = std::numeric_limits<double>::infinity();
  localStep_->begin();
  for (auto* rotations : {&guess_, &rotations_}) std::fill(rotations->begin(), rotations->end(), identityRotations());
  applyHandles(handles_, positions);
}

Status LocalGlobal::step(Points& positions, StepReport& report) {
  if (stopping_.exhausted()) {
    report = {Outcome::iterationLimit, 0, 0};
    return {};
  }
  guess_.swap(rotations_);
  const bool extrapolated = acceleration_.extrapolate(positions, previous_);
  if (localStep_->followsOutput()) energy_ = std::numeric_limits<double>::infinity();
  report.energy = localStep(acceleration_.start(), Guess::continued);
  if (extrapolated && !(report.energy <= energy_)) {
    acceleration_.reject(positions);
    report.energy = localStep(positions, Guess::last);
  }
  // Not from an exact local step, but ADMM stops within its tolerance and, for strong pulls, at local maxima.
  if (report.energy > energy_ + kRounding * std::abs(energy_)) report.energy = localStep(positions, Guess::bound);
  energy_ = report.energy;
  previous_.swap(positions);
  globalStep(acceleration_.start(), positions);
  report.change = relativeDisplacement(positions);
  if (!std::isfinite(report.energy) || !std::isfinite(report.change)) {
    positions = previous_;
    return Status::failure(Code::numericalFailure,
                           "the iteration lost its numbers; the mesh may hold faces too thin to compute with");
  }
  report.outcome = stopping_.judge(report);
  return {};
}

double LocalGlobal::localStep(const Points& positions, Guess guess) {
  localStep_->observe(positions);
  std::fill(residual_.begin(), residual_.end(), LaneRow{});
  double energy = edges_->restEnergy() + localStep_->pullEnergy();
  const Index count = edges_->elementCount();
  for (Index first = 0; first < count; first += kBlock) {
    const ElementRange block{first, std::min(first + kBlock, count)};
    energy += edges_->gatherCovariances(positions, block, covariances_.data(), residual_);
    energy += fitBlock(block, guess);
    edges_->addSimilar(rotations_, scales_ ? scales_->growths() : kNoGrowths, block, residual_);
  }
  return energy;
}

double LocalGlobal::fitBlock(ElementRange block, Guess guess) {
  double energy = 0;
  for (std::size_t b = block.firstBatch(); b < block.endBatch(); ++b) {
    CovarianceLanes& M = covariances_[b - block.firstBatch()];
    rotations_[b] = guess == Guess::continued ? continued(guess_[b], rotations_[b]) : guess_[b];
    localStep_->pull(b, M);
    const Lanes regularizers = localStep_->fit(b, ScaledCovariances(M), guess == Guess::bound, rotations_[b]);
    const DoubleLanes gains = traces(rotations_[b], M);
    energy += sumOf(toDouble(regularizers) - gains);
    if (scales_) energy += scales_->fit(b, gains);
  }
  return energy;
}

void LocalGlobal::globalStep(const Points& from, Points& positions) {
  system_.correct(residual_, from, positions);
  gauge_->restoreCentroids(positions);
}

double LocalGlobal::relativeDisplacement(const Points& positions) const {
  const Points &start = acceleration_.start(), &rest = rest_->mesh.positions;
  double move = 0, way = 0, sum = 0;  // squared
  for (Index v = 0; v < positions.rows(); ++v) {
    const auto x = positions.row(v);
    const double fromRest = (x - rest.row(v)).squaredNorm();
    move = std::max({move, (x - start.row(v)).squaredNorm(), (x - previous_.row(v)).squaredNorm()});
    way = std::max(way, fromRest);
    sum += fromRest;  // a maximum does not see what is not a number
  }
  if (!std::isfinite(sum)) return std::numeric_limits<double>::quiet_NaN();
  return StoppingRule::relativeDisplacement(move, way);
}

}  // namespace whittle
