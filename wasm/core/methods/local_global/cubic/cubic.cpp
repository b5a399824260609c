#include "methods/local_global/cubic/cubic.h"

#include "geometry/surface.h"
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

}  // namespace

Status CubicLocalStep::check(const CubicParameters& values) {
  if (isBox(values) || values.lambdaAxes == Vec3::Ones()) return {};
  return Status::failure(
      Code::badParameter,
      "only the cube has axes to weigh; leave lambdaAxes at 1, 1, 1 or choose the polyhedron \"cube\"");
}

std::vector<std::string> CubicLocalStep::warnings(const CubicParameters& values) {
  const bool isFlat = (values.lambdaPerVertex.size() ? values.lambdaPerVertex.isZero(0) : values.lambda == 0) ||
                      (values.lambdaOnGaussMap && values.lambdaOnGaussMap->values.isZero(0));
  if (!isFlat || !values.handles.vertices.empty() || !values.planes.empty()) return {};
  return {"λ is 0 everywhere and there are no handles, so nothing moves."};
}

void CubicLocalStep::prepare(const RestShape& rest, const CubicParameters& values) {
  prepareVertices(rest, values);
  prepareStyle(values);
  frames_.prepare(values.orientation, values.frames, rest.mesh.vertexCount());
  begin();
}

void CubicLocalStep::prepareVertices(const RestShape& rest, const CubicParameters& values) {
  const auto& [positions, triangles] = rest.mesh;
  const SmoothFans& fans = rest.fans;
  const Points normals = fans.areVertices() ? rest.normals : fanNormals(positions, triangles, fans);
  const Scalars areas = fans.areVertices() ? rest.areas : barycentricAreas(positions, triangles, fans);
  const Scalars& own = values.lambdaPerVertex;
  const SphereField* const onGaussMap = values.lambdaOnGaussMap.get();
  const auto cubeness = [&](Index v, const Vec3& n) {  // λ_i, Eq. 1
    return (own.size() ? own[v] : values.lambda) * (onGaussMap ? (*onGaussMap)(n) : 1);
  };
  layout_ = FanLayout(fans);
  fans_.assign(layout_.slotCount(), {{splat(0), splat(0), splat(0)}, splat(0)});
  for (Index v = 0; v < rest.mesh.vertexCount(); ++v) {
    for (Index fan = fans.start[v]; fan < fans.start[v + 1]; ++fan) {
      FanLanes& lanes = fans_[layout_.lanes[fan] / 4];
      const Vec3 n = normals.row(fan).transpose();
      setVector(lanes.n, v % 4, n);
      if (!n.isZero(0)) lanes.weight[v % 4] = static_cast<float>(cubeness(v, n) * areas[fan]);
    }
  }
  normals_.resize(static_cast<std::size_t>(layout_.most));
}

void CubicLocalStep::prepareStyle(const CubicParameters& values) {
  const auto& [name, rows] = values.polyhedron;
  if (isBox(values)) {
    polyhedron_ = Polyhedron::box(values.lambdaAxes);
  } else {
    polyhedron_ = values.polyhedron.isNamed() ? Polyhedron::named(name) : Polyhedron::ofRows(rows);
  }
  if (values.localStep == CubicSolverKind::admm) {
    solver_ = std::make_unique<CubicAdmm>(polyhedron_);
  } else if (isBox(values)) {
    solver_ = std::make_unique<CubicExact>(values.lambdaAxes);
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
  const FanLanes* const fans = fans_.data();
  const CubicLanes vertices{M, {fans + layout_.start[batch], fans + layout_.start[batch + 1]}};
  const QuaternionLanes guess = rotations;
  Lanes regularizers = solver_->solve(batch, vertices, rotations);
  if (neverWorse) keepBetter(vertices, guess, rotations, regularizers);
  return regularizers;
}

void CubicLocalStep::keepBetter(const CubicLanes& vertices, const QuaternionLanes& guess, QuaternionLanes& rotations,
                                Lanes& regularizers) {
  for (int lane = 0; lane < 4; ++lane) {
    const FanVertex vertex{matrixAt(vertices.M, lane), normalsAt(vertices, lane, normals_), polyhedron_};
    const Mat3 before = rotationAt(guess, lane);
    if (vertex.objective(rotationAt(rotations, lane)) >= vertex.objective(before)) continue;
    setRotation(rotations, lane, before);
    regularizers[lane] = static_cast<float>(polyhedron_.regularizer(vertex.normals, before));
  }
}

MethodInfo cubicMethod() {
  using P = CubicParameters;
  const ChoiceKind<CubicSolverKind> solvers{{{"exact", CubicSolverKind::exact}, {"admm", CubicSolverKind::admm}}};
  const ChoiceOrRowsKind<Polyhedron::Name> polyhedra{{Polyhedron::names()}, Polyhedron::kMostRows};
  const ParameterList<P> own = {bind("lambda", &P::lambda, Stale::weights, NumberKind{{0, 100}}),
                                bind("lambdaPerVertex", &P::lambdaPerVertex, Stale::weights, ScalarsKind{{0, 100}}),
                                bind("lambdaOnGaussMap", &P::lambdaOnGaussMap, Stale::weights, SphereFieldKind{}),
                                bind("lambdaAxes", &P::lambdaAxes, Stale::weights, VectorKind<3>{{0, 100}}),
                                bind("polyhedron", &P::polyhedron, Stale::weights, polyhedra),
                                bind("orientation", &P::orientation, Stale::weights, RotationKind{}),
                                bind("frames", &P::frames, Stale::weights, RotationsKind{}),
                                bind("localStep", &P::localStep, Stale::weights, solvers),
                                bind("handles", &P::handles, Stale::system, HandlesKind{}),
                                bind("planes", &P::planes, Stale::system, PlanesKind{}),
                                bind("parts", &P::parts, Stale::system, waysOfParts())};
  return methodInfo<LocalGlobalMethod<CubicLocalStep>>("cubic", withGroup(own, &P::solver, solverParameters()));
}

}  // namespace whittle
