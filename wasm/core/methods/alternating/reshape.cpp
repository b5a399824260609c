#include "methods/alternating/reshape.h"

#include <algorithm>
#include <cmath>

#include "mesh/bounding_box.h"
#include "methods/alternating/fold_check.h"
#include "methods/alternating/marked_lines.h"
#include "methods/alternating/reshape_rows.h"

namespace whittle {

namespace {

/// Rounding of a target that is where its vertex is.
constexpr double kNoMove = 1e-9;
/// Targets farther away than so many times the longest side are a mistake.
constexpr double kFarthest = 1e3;

/// The print has no term for the thickness of walls.
bool keepsWalls(const ReshapeParameters& values) {
  return values.variant == Variant::slippage && values.reading == Reading::tuned;
}

ChoiceKind<Variant> variants() {
  return {{{"slippage", Variant::slippage},
           {"alup", Variant::alup},
           {"poisson", Variant::poisson},
           {"arap", Variant::arap},
           {"conformal", Variant::conformal}}};
}

}  // namespace

Status Reshape::check(const ReshapeParameters& values) const {
  for (Index h = 0; h < values.handles.targets.rows(); ++h) {
    if (values.handles.targets.row(h).norm() < kFarthest) continue;
    return Status::failure(
        Code::badHandles,
        "the target of vertex {} is more than a thousand times as far away as the shape is long; are "
        "its units those of the file?",
        Element::vertex(values.handles.vertices[h]));
  }
  for (const VertexChains* chains : {&values.features, &values.smooth, &values.straight}) {
    for (const std::vector<Index>& chain : *chains) {
      if (chain.size() < 2) return Status::failure(Code::badParameter, "a line needs two vertices at least");
    }
  }
  return {};
}

std::vector<Stage> Reshape::plan(const TriangleMesh& rest, const ReshapeParameters& values, Stale stale) {
  rest_ = &rest;
  Plan plan(stale);
  const bool wasLocalGlobal = isLocalGlobal(), isFirst = emitted_.size() == 0;
  variant_ = values.variant;
  if (isLocalGlobal()) {
    planLocalGlobal(rest, values, wasLocalGlobal && !isFirst ? stale : std::max(stale, Stale::all), plan);
    return plan.stages();
  }
  working_.addStages(rest, values, plan);
  plan.add(Stale::system, "assembling the system", 10, [this, &values] { shape(values); })
      .add(Stale::system, "factoring the system", 40,
           [this](double& done) {
             return variant_ == Variant::poisson ? poisson_.prepareNext(done) : run_.prepareNext(done);
           })
      .add(Stale::targets, "taking the handles", 2, [this, &values] { aim(values); });
  return plan.stages();
}

ArapParameters Reshape::arapValues(const ReshapeParameters& values) const {
  ArapParameters result;
  result.regularizer = values.variant == Variant::conformal ? Rigidity::acap : Rigidity::arap;
  result.handles = values.handles;
  result.parts = values.parts;
  result.solver.maxIterations = values.maxIterations;
  return result;
}

void Reshape::planLocalGlobal(const TriangleMesh& rest, const ReshapeParameters& values, Stale stale, Plan& plan) {
  arapValues_ = arapValues(values);
  std::vector<Stage> stages = arap_.plan(rest, arapValues_, stale);
  // A value that is set while stages wait must reach those that read it.
  for (Stage& stage : stages) {
    stage.run = [this, &values, run = std::move(stage.run)](double& done) {
      arapValues_ = arapValues(values);
      return run(done);
    };
  }
  plan.add(stages).add(Stale::targets, "taking the handles", 1, [this, &values] {
    handles_ = values.handles;
    setGesture();
  });
}

void Reshape::shape(const ReshapeParameters& values) {
  RunRows rows;
  rows.handles = aimed(values);
  keptWalls_ = keptWalls(working_.structure().walls, working_.surface(), rows.handles);
  rows.others = otherRows(values, rows.handles);
  straightRemarks_ = linesKeptByNothing("straight", values.straight, *rest_, working_.surface());
  emitted_.resize(0, 3);
  if (variant_ == Variant::poisson) {
    rows.handles.insert(rows.handles.end(), rows.others.begin(), rows.others.end());
    poisson_.shape(working_.surface(), std::move(rows.handles));
    return;
  }
  const Box box = boundingBox(*rest_);
  run_.shape(working_.surface(), working_.structure(),
             {values.variant, values.reading, working_.features(), box.diagonal().norm()}, std::move(rows));
}

std::vector<PointRow> Reshape::otherRows(const ReshapeParameters& values, const std::vector<PointRow>& handles) const {
  const Points& positions = working_.surface().mesh.positions;
  std::vector<PointRow> rows;
  if (values.parts == Parts::together) {
    addAttachmentRows(working_.attachments(), positions, rows);
    addScaffoldRows(working_.scaffold(), positions, rows);
  }
  if (values.variant != Variant::poisson) {
    const bool isAcross = values.reading == Reading::tuned;
    const RestSurface& surface = working_.surface();
    addStraightRows(working_.structure().straightChains, {.asAtRest = true, .isAcross = isAcross}, surface, rows);
    addStraightRows(chainsAlong(values.straight, rest_->positions, surface), {.isAcross = isAcross}, surface, rows);
  }
  if (keepsWalls(values)) addWallRows(working_.structure().walls, keptWalls_, working_.surface(), rows);
  addPins(working_.surface(), handles, rows);
  return rows;
}

/// The rows of the handles with their targets.
std::vector<PointRow> Reshape::aimed(const ReshapeParameters& values) const {
  std::vector<PointRow> rows;
  for (std::size_t h = 0; h < values.handles.vertices.size(); ++h) {
    if (!working_.carries(values.handles.vertices[h])) continue;
    PointRow row = handleRow(*rest_, working_.mesh(), working_.transfer(), values.handles.vertices[h]);
    row.target =
        row.residual(working_.mesh().mesh.positions) + values.handles.targets.row(static_cast<Index>(h)).transpose();
    rows.push_back(row);
  }
  return rows;
}

void Reshape::setGesture() {
  isGesture_ = false;
  for (std::size_t h = 0; h < handles_.vertices.size(); ++h) {
    const Vec3 move = handles_.targets.row(static_cast<Index>(h)) - rest_->positions.row(handles_.vertices[h]);
    // A target in the file's units comes back from them with a rounding.
    isGesture_ = isGesture_ || move.norm() > kNoMove;
  }
}

void Reshape::aim(const ReshapeParameters& values) {
  handles_ = values.handles;
  setGesture();
  const std::vector<PointRow> handles = aimed(values);
  // A wall whose sides are now moved apart is no wall any more.
  if (keepsWalls(values) && keptWalls(working_.structure().walls, working_.surface(), handles) != keptWalls_)
    shape(values);
  std::vector<Vec3> targets;
  for (const PointRow& handle : handles) targets.push_back(handle.target);
  if (variant_ == Variant::poisson) {
    poisson_.aim(targets);
    return;
  }
  run_.limit(values.finalize, values.maxIterations);
  run_.aim(targets);
}

void Reshape::begin(Points& positions) {
  if (isLocalGlobal()) {
    if (isGesture_) arap_.begin(positions);
    return;
  }
  if (variant_ == Variant::poisson) return;
  const bool isAtRest = positions == rest_->positions;
  if (isAtRest || positions.rows() != emitted_.rows() || positions != emitted_)
    run_.begin();
  else
    run_.resume();
}

Status Reshape::step(Points& positions, StepReport& report) {
  if (!isGesture_) {
    positions = rest_->positions;
    report = {Outcome::converged, 0, 0};
    return {};
  }
  if (isLocalGlobal()) return arap_.step(positions, report);
  const bool isPoisson = variant_ == Variant::poisson;
  if (Status status = isPoisson ? poisson_.step(report) : run_.step(report); !status.ok()) return status;
  if (report.outcome == Outcome::midway) return {};
  workingPositions_ = isPoisson ? poisson_.positions() : run_.positions();
  working_.transfer().carry(workingPositions_, positions);
  for (std::size_t h = 0; h < handles_.vertices.size(); ++h) {
    if (!working_.carries(handles_.vertices[h]))
      positions.row(handles_.vertices[h]) = handles_.targets.row(static_cast<Index>(h));
  }
  emitted_ = positions;
  return {};
}

std::vector<std::string> Reshape::warnings(const ReshapeParameters& values) const {
  if (values.handles.vertices.empty())
    return {"Nothing is held, so nothing moves: reshape needs handles; hold some vertices and drag others."};
  if (isLocalGlobal()) return arap_.warnings(arapValues_);
  std::vector<std::string> remarks = working_.remarks();
  if (variant_ != Variant::poisson) {
    remarks.insert(remarks.end(), straightRemarks_.begin(), straightRemarks_.end());
    remarks.insert(remarks.end(), run_.remarks().begin(), run_.remarks().end());
  }
  if (const Index turned = turnedOnTheWayBack(); turned > 0) {
    remarks.push_back(std::to_string(turned) + " of the file's own thin faces " + (turned == 1 ? "turns" : "turn") +
                      " over within flat sides; the shape is not changed by it.");
  }
  return remarks;
}

Index Reshape::turnedOnTheWayBack() const {
  if (!isGesture_ || !working_.isOther() || emitted_.rows() != rest_->vertexCount()) return 0;
  return turnedInPlane(*rest_, emitted_, {working_.surface(), workingPositions_, working_.transfer()});
}

std::vector<Field> Reshape::fields() const {
  if (isLocalGlobal()) return arap_.fields();
  if (variant_ == Variant::poisson) return {};
  const auto lines = [](const char* name, const char* label, const std::vector<Index>& vertices) {
    return Field{name,
                 label,
                 Field::Per::line,
                 "",
                 [vertices](Scalars& values) { std::copy(vertices.begin(), vertices.end(), values.begin()); },
                 static_cast<Index>(vertices.size() / 2)};
  };
  const Structure& structure = working_.structure();
  return {Field{"sphericity", "Round as a ball", Field::Per::vertex, "",
                [this](Scalars& values) { values = working_.onInput(run_.sphericity()); }},
          lines("creases", "Creases", working_.linesOnInput(structure.features)),
          lines("straight", "Straight lines", working_.linesOnInput(structure.straightChains))};
}

MethodInfo reshapeMethod() {
  using P = ReshapeParameters;
  const ChoiceKind<Reading> readings{{{"tuned", Reading::tuned}, {"published", Reading::published}}};
  const ChoiceKind<Remesh> ways{{{"auto", Remesh::automatic}, {"never", Remesh::never}, {"always", Remesh::always}}};
  return methodInfo<Reshape>(
      "reshape",
      {bind("variant", &P::variant, Stale::all, variants()), bind("reading", &P::reading, Stale::system, readings),
       bind("handles", &P::handles, Stale::system, HandlesKind{}),
       bind("featureAngle", &P::featureAngle, Stale::all, NumberKind{{1, 180}}),
       bind("features", &P::features, Stale::all, ChainsKind{}), bind("smooth", &P::smooth, Stale::all, ChainsKind{}),
       bind("straight", &P::straight, Stale::system, ChainsKind{}),
       bind("finalize", &P::finalize, Stale::targets, FlagKind{}), bind("remesh", &P::remesh, Stale::all, ways),
       bind("parts", &P::parts, Stale::system, waysOfParts()),
       bind("maxIterations", &P::maxIterations, Stale::targets, kIterations)});
}

}  // namespace whittle
