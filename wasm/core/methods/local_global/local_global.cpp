#include "methods/local_global/local_global.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/rotation_fit.h"
#include "geometry/surface.h"

namespace whittle {

namespace {

/// Share of the energy, and of the size of the terms that cancel in it, that single precision decides.
constexpr double kRounding = 2e-8;

/// Elements that go through the local step together: as many as the nearest cache holds all of.
constexpr Index kBlock = 64;

}  // namespace

std::vector<Stage> LocalGlobal::plan(const TriangleMesh& rest, std::function<EngineValues()> values,
                                     std::function<void(const RestShape& rest)> prepareStep, Stale stale) {
  return Plan(stale)
      .add(Stale::all, "measuring the mesh", 3, [this, &rest] { measure(rest); })
      .add(Stale::all, "collecting the edges", 4, [this, values] { beginCollecting(values().rigidity); })
      .add(Stale::all, "collecting the edges", 8, [this](double& done) { collectEdges(done); })
      .add(Stale::all, "finding where parts touch", 3, [this](double& done) { findContacts(done); })
      .add(Stale::system, "assembling the system", 4, [this, values] { assembleSystem(values()); })
      .add(Stale::system, "factoring the system", 80, [this](double& done) { return system_.prepareNext(done); })
      .add(Stale::weights, "preparing the local step", 2,
           [this, prepareStep] {
             prepareStep(*rest_);
             if (scales_) scales_->prepare(*edges_, localStep_.targetWeights());
           })
      .add(Stale::targets, "taking the settings", 1,
           [this, values](double&) {
             const auto [rigidity, handles, solver, parts, planes] = values();
             handles_ = handles;
             accelerationKind_ = solver.acceleration;
             stopping_.quantity = solver.stopOn;
             stopping_.tolerance = solver.tolerance;
             stopping_.maxIterations = solver.maxIterations;
             return joinPlanes(rowPlanes(planes), onPlanes_);
           })
      .stages();
}

void LocalGlobal::measure(const TriangleMesh& rest) {
  const auto& [positions, triangles] = rest;
  rest_.emplace(RestShape{rest, barycentricAreas(positions, triangles), vertexNormals(positions, triangles),
                          smoothFans(positions, triangles)});
  halfCotangents_ = halfCotangents(rest.positions, rest.triangles);
  components_ = connectedComponents(rest.triangles, rest.vertexCount());
  contactSearch_.reset();  // what was broken off knows another shape
}

void LocalGlobal::beginCollecting(Rigidity rigidity) {
  edges_ = makeEdgeSet(edgeSetOf(rigidity), rest_->mesh, halfCotangents_);
  scales_.reset();
  if (rigidity == Rigidity::acap) scales_.emplace(edges_->elementCount());
  isClaimed_ = false;
}

void LocalGlobal::collectEdges(double& done) {
  done = edges_->collectNext();
  if (done < 1) return;
  sizeOfTerms_ = 0;
  for (const SymmetricLanes& M : edges_->restCovariances()) sizeOfTerms_ += sumOf(toDouble(M.xx + M.yy + M.zz));
}

void LocalGlobal::findContacts(double& done) {
  const auto& [mesh, areas, normals, fans] = *rest_;
  // Parts that share a vertex bend there: a smooth surface hangs together by edges.
  if (!contactSearch_)
    contactSearch_ =
        std::make_unique<ContactSearch>(mesh, fans.areVertices() ? components_.ofFaces(mesh.triangles)
                                                                 : partsByEdges(mesh.triangles, mesh.vertexCount()));
  done = contactSearch_->next();
  if (done < 1) return;
  contacts_ = Attachments(contactSearch_->take());
  contactSearch_.reset();
}

void LocalGlobal::claimRunningState() {
  const Index vertexCount = rest_->mesh.vertexCount();
  for (auto* rotations : {&guess_, &rotations_})
    rotations->assign(batchCount(edges_->elementCount()), identityRotations());
  covariances_.resize(batchCount(kBlock));
  rotationChanges_.resize(batchCount(kBlock));
  residual_.assign(ConstrainedQuadratic::paddedRows(vertexCount), {});
  for (auto* displacements : {&displacements_, &previous_}) displacements->resize(vertexCount, edges_->stiffEdges());
  acceleration_.resize(vertexCount, edges_->stiffEdges());
  isClaimed_ = true;
}

void LocalGlobal::assembleSystem(const EngineValues& values) {
  attachments_ = values.parts == Parts::together ? contacts_ : Attachments();
  gauge_.emplace(attachments_.tied(components_), values.handles.vertices, rest_->mesh.positions, rest_->areas,
                 values.planes);
  std::vector<Index> held = values.handles.vertices;
  held.insert(held.end(), gauge_->pins().begin(), gauge_->pins().end());
  std::vector<RowPlane> planes = rowPlanes(values.planes);
  planes.insert(planes.end(), gauge_->pinPlanes().begin(), gauge_->pinPlanes().end());
  const TriangleMesh& mesh = rest_->mesh;
  SparseMatrix matrix = cotangentLaplacian(mesh.triangles, halfCotangents_, mesh.vertexCount());
  Ordering ordering{.isOrdered = true};
  if (!attachments_.empty()) {
    matrix += attachments_.lower(mesh.vertexCount());
    ordering = {.coordinates = &mesh.positions};  // that of the vertices does not know of the ties
  }
  system_.beginPrepare(std::move(matrix), std::move(held), ordering, std::move(planes));
}

void LocalGlobal::applyConstraints(Points& positions) const {
  satisfyPlanes(onPlanes_, positions);
  applyHandles(handles_, positions);  // to the bit
}

void LocalGlobal::begin(Points& positions) {
  if (!isClaimed_) claimRunningState();
  stopping_.begin();
  acceleration_.begin(localStep_.followsOutput() ? Acceleration::Kind::none : accelerationKind_);
  energy_ = std::numeric_limits<double>::infinity();
  localStep_.begin();
  for (auto* rotations : {&guess_, &rotations_}) std::fill(rotations->begin(), rotations->end(), identityRotations());
  applyConstraints(positions);
  displacements_.measure(positions, rest_->mesh.positions);
  best_.begin(localStep_.keepsBest(), positions);
}

Status LocalGlobal::step(Points& positions, StepReport& report) {
  if (stopping_.exhausted()) {
    report = {Outcome::iterationLimit, 0, 0};
    return {};
  }
  guess_.swap(rotations_);
  const bool extrapolated = acceleration_.extrapolate(displacements_, previous_);
  if (localStep_.followsOutput()) {
    localStep_.observe(positions);
    energy_ = std::numeric_limits<double>::infinity();
  }
  report.energy = localStep(acceleration_.start(), Guess::continued);
  if (extrapolated && !(report.energy <= energy_)) {
    acceleration_.reject(displacements_);
    report.energy = localStep(displacements_, Guess::last);
  }
  // Not from an exact local step, but ADMM stops within its tolerance and, for strong regularizers, at local maxima.
  if (report.energy > energy_ + kRounding * (std::abs(energy_) + sizeOfTerms_))
    report.energy = localStep(displacements_, Guess::bound);
  energy_ = report.energy;
  best_.offer(positions, report.energy);
  std::swap(previous_, displacements_);
  report.change = std::isfinite(report.energy) ? globalStep(positions) : std::numeric_limits<double>::quiet_NaN();
  if (!std::isfinite(report.change)) {
    displacements_ = previous_;  // the positions are still those
    return Status::failure(Code::numericalFailure,
                           "the iteration lost its numbers; the mesh may hold faces too thin to compute with");
  }
  report.outcome = stopping_.judge(report);
  if (report.outcome != Outcome::running && best_.take(positions))
    displacements_.measure(positions, rest_->mesh.positions);
  return {};
}

double LocalGlobal::localStep(const Displacements& displacements, Guess guess) {
  std::fill(residual_.begin(), residual_.end(), LaneRow{});
  double energy =
      localStep_.targetEnergy() + edges_->visits() * (edges_->stiffEdges().addForces(displacements.exact(), residual_) +
                                                      attachments_.addForces(displacements.rows(), residual_));
  const Index count = edges_->elementCount();
  for (Index first = 0; first < count; first += kBlock) {
    const ElementRange block{first, std::min(first + kBlock, count)};
    energy += edges_->gatherCovariances(displacements.rows(), block, covariances_.data(), residual_);
    energy += fitBlock(block, guess);
    edges_->addRotationChanges(rotationChanges_.data(), block, residual_);
  }
  return energy < 0 ? 0 : energy;  // a sum of squares, but for rounding
}

double LocalGlobal::fitBlock(ElementRange block, Guess guess) {
  DoubleLanes energies{};
  for (std::size_t b = block.firstBatch(); b < block.endBatch(); ++b) {
    MatrixLanes& covariances = covariances_[b - block.firstBatch()];
    MatrixLanes& rotationChanges = rotationChanges_[b - block.firstBatch()];
    QuaternionLanes& rotations = rotations_[b];
    const SymmetricLanes& rest = edges_->restCovariances()[b];
    localStep_.addTargetTerm(b, covariances);
    rotations = guess == Guess::continued ? continued(guess_[b], rotations) : guess_[b];
    const Lanes regularizers = localStep_.fit(b, rest + covariances, guess == Guess::bound, rotations);
    rotationChanges = rotationChange(rotations);
    const Lanes alignmentGains = traceOfProduct(rotationChanges, rest) + traceOfProduct(rotationChanges, covariances);
    Lanes changes = regularizers - alignmentGains;
    if (scales_) changes += scales_->fit(b, alignmentGains, covariances, rotationChanges);
    energies += toDouble(changes);
  }
  return sumOf(energies);
}

double LocalGlobal::globalStep(Points& positions) {
  system_.correct(residual_);
  const Displacements& start = acceleration_.start();
  gauge_->balance(start.rows(), residual_);
  LaneRows& rows = displacements_.rows();
  Lanes move = splat(0), displacement = splat(0), sum = splat(0);  // squared lengths
  for (std::size_t v = 0; v < rows.size(); v += 4) {
    Lanes steps[4], jumps[4], lengths[4];  // from where the iteration started, from the iterate before, from rest
    for (std::size_t lane = 0; lane < 4; ++lane) {
      const Lanes from = load(&start.rows()[v + lane]);
      const Lanes to = from + (load(&residual_[v + lane]) + gauge_->shift(v + lane));
      const Lanes step = to - from, jump = to - load(&previous_.rows()[v + lane]);
      store(&rows[v + lane], to);
      steps[lane] = step * step, jumps[lane] = jump * jump, lengths[lane] = to * to;
    }
    const Lanes stepped = horizontalSums(steps[0], steps[1], steps[2], steps[3]);
    const Lanes jumped = horizontalSums(jumps[0], jumps[1], jumps[2], jumps[3]);
    const Lanes displaced = horizontalSums(lengths[0], lengths[1], lengths[2], lengths[3]);
    move = maximum(move, maximum(stepped, jumped));
    displacement = maximum(displacement, displaced);
    sum += displaced;  // a maximum does not see what is not a number
  }
  if (!std::isfinite(sumOf(toDouble(sum)))) return std::numeric_limits<double>::quiet_NaN();
  displacements_.setExact([&](Index place, Index v) -> Eigen::RowVector3d {
    const Lanes step = load(&residual_[v]) + gauge_->shift(v);
    return start.exact().row(place) + Eigen::RowVector3d(step[0], step[1], step[2]);
  });
  displacements_.apply(rest_->mesh.positions, positions);
  applyConstraints(positions);
  if (!onPlanes_.empty()) displacements_.measure(positions, rest_->mesh.positions);  // or rounding would add up
  const auto largest = [](Lanes v) { return std::max({v[0], v[1], v[2], v[3]}); };
  return StoppingRule::relativeDisplacement(largest(move), largest(displacement));
}

std::vector<std::string> LocalGlobal::warnings() const {
  if (!best_.wasTaken()) return {};
  return {
      "The targets that follow the output came to fit it worse than at the beginning, so the best shape on the way was "
      "kept, that of iteration " +
      std::to_string(best_.iteration()) + "; without dynamicTargets the fit only improves."};
}

std::vector<Field> LocalGlobal::fields() const {
  if (!scales_) return {};
  return {{"size", "Change of size", Field::Per::vertex, "×", [this](Scalars& values) { scales_->copyTo(values); }}};
}

}  // namespace whittle
