#include "methods/local_global/cubic/cubic.h"

#include "geometry/rotation_fit.h"
#include "methods/local_global/cubic/cubic_admm.h"
#include "methods/local_global/cubic/cubic_exact.h"
#include "methods/local_global/cubic/polyhedral_exact.h"
#include "methods/local_global/local_global_method.h"

namespace whittle {

namespace {

/// Whether the style is a cube or, with axes of other weights, a box.
bool isBox(const CubicParameters& values) {
  return values.polyhedron.isNamed() && values.polyhedron.name == Polyhedron::Name::cube;
}

/// Goes back to the guess in lanes where it is better.
void keepBetter(const CubicLanes& vertices, Lanes weights, const Polyhedron& polyhedron, const QuaternionLanes& guess,
                QuaternionLanes& rotations, Lanes& regularizers) {
  for (int lane = 0; lane < 4; ++lane) {
    const CubicVertex cubic = vertexAt(vertices, lane);
    const PolyhedralVertex vertex(cubic.M, cubic.n, weights[lane], polyhedron);
    const Mat3 before = rotationAt(guess, lane);
    if (vertex.objective(rotationAt(rotations, lane)) >= vertex.objective(before)) continue;
    setRotation(rotations, lane, before);
    regularizers[lane] = static_cast<float>(vertex.weight * polyhedron.support(before * vertex.n));
  }
}

}  // namespace

Status CubicLocalStep::check(const CubicParameters& values) {
  if (isBox(values) || values.lambdaAxes == Vec3::Ones()) return {};
  return Status::failure(
      Code::badParameter,
      "only the cube has axes to weigh; leave lambdaAxes at 1, 1, 1 or choose the polyhedron \"cube\"");
}

std::vector<std::string> CubicLocalStep::warnings(const CubicParameters& values) {
  const bool isFlat = values.lambdaPerVertex.size() ? values.lambdaPerVertex.isZero(0) : values.lambda == 0;
  if (!isFlat || !values.handles.vertices.empty()) return {};
  return {"λ is 0 everywhere and there are no handles, so nothing moves."};
}

void CubicLocalStep::prepare(const RestShape& rest, const CubicParameters& values) {
  prepareVertices(rest, values);
  prepareStyle(values);
  frames_.prepare(values.orientation, values.frames, rest.mesh.vertexCount());
  begin();
}

void CubicLocalStep::prepareVertices(const RestShape& rest, const CubicParameters& values) {
  const Scalars& own = values.lambdaPerVertex;
  const auto cubeness = [&](Index v) { return own.size() ? own[v] : values.lambda; };  // λ_i, Eq. 1
  const std::size_t batches = batchCount(rest.mesh.vertexCount());
  normals_.assign(batches, {splat(0), splat(0), splat(0)});
  weights_.assign(batches, splat(0));
  for (Index v = 0; v < rest.mesh.vertexCount(); ++v) {
    const Vec3 n = rest.normals.row(v).transpose();
    setVector(normals_[v / 4], v % 4, n);
    if (!n.isZero(0)) weights_[v / 4][v % 4] = static_cast<float>(cubeness(v) * rest.areas[v]);
  }
}

void CubicLocalStep::prepareStyle(const CubicParameters& values) {
  const auto& [name, rows] = values.polyhedron;
  if (isBox(values)) {
    polyhedron_ = Polyhedron::box(values.lambdaAxes);
  } else {
    polyhedron_ = values.polyhedron.isNamed() ? Polyhedron::named(name) : Polyhedron::ofRows(rows);
  }
  axes_ = Vec3::Ones();
  if (values.localStep == CubicSolverKind::admm) {
    solver_ = std::make_unique<CubicAdmm>(polyhedron_);
  } else if (isBox(values)) {
    solver_ = std::make_unique<CubicExact>();
    axes_ = values.lambdaAxes;
  } else {
    solver_ = std::make_unique<PolyhedralExact>(polyhedron_);
  }
}

Lanes CubicLocalStep::fit(std::size_t batch, const MatrixLanes& covariances, bool neverWorse,
                          QuaternionLanes& rotations) {
  if (frames_.areIdentity()) return solve(batch, covariances, neverWorse, rotations);
  const QuaternionLanes before = frames_.intoFrames(batch, rotations);
  QuaternionLanes after = before;
  const Lanes regularizers = solve(batch, frames_.covariances(batch, covariances), neverWorse, after);
  frames_.outOfFrames(batch, before, after, rotations);
  return regularizers;
}

Lanes CubicLocalStep::solve(std::size_t batch, const MatrixLanes& M, bool neverWorse, QuaternionLanes& rotations) {
  const Lanes weights = weights_[batch];
  const VectorLanes axes{splat(static_cast<float>(axes_.x())), splat(static_cast<float>(axes_.y())),
                         splat(static_cast<float>(axes_.z()))};
  const CubicLanes vertices{M, normals_[batch], {weights * axes.x, weights * axes.y, weights * axes.z}};
  const QuaternionLanes guess = rotations;
  Lanes regularizers = solver_->solve(batch, vertices, rotations);
  if (neverWorse) keepBetter(vertices, weights, polyhedron_, guess, rotations, regularizers);
  return regularizers;
}

MethodInfo cubicMethod() {
  using P = CubicParameters;
  const ChoiceKind<CubicSolverKind> solvers{{{"exact", CubicSolverKind::exact}, {"admm", CubicSolverKind::admm}}};
  const ChoiceOrRowsKind<Polyhedron::Name> polyhedra{{Polyhedron::names()}, Polyhedron::kMostRows};
  const ParameterList<P> own = {bind("lambda", &P::lambda, Stale::weights, NumberKind{{0, 100}}),
                                bind("lambdaPerVertex", &P::lambdaPerVertex, Stale::weights, ScalarsKind{{0, 100}}),
                                bind("lambdaAxes", &P::lambdaAxes, Stale::weights, VectorKind<3>{{0, 100}}),
                                bind("polyhedron", &P::polyhedron, Stale::weights, polyhedra),
                                bind("orientation", &P::orientation, Stale::weights, RotationKind{}),
                                bind("frames", &P::frames, Stale::weights, RotationsKind{}),
                                bind("localStep", &P::localStep, Stale::weights, solvers),
                                bind("handles", &P::handles, Stale::system, HandlesKind{}),
                                bind("parts", &P::parts, Stale::system, waysOfParts())};
  return methodInfo<LocalGlobalMethod<CubicLocalStep>>("cubic", withGroup(own, &P::solver, solverParameters()));
}

}  // namespace whittle
