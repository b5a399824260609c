#include "methods/local_global/cubic/cubic.h"

#include "geometry/rotation_fit.h"
#include "methods/local_global/cubic/cubic_admm.h"
#include "methods/local_global/cubic/cubic_exact.h"
#include "methods/local_global/cubic/polyhedral_exact.h"
#include "methods/local_global/local_global.h"

namespace whittle {

namespace {

enum Parameter { kLambda, kLambdaPerVertex, kLambdaAxes, kPolyhedron, kOrientation, kFrames, kLocalStep, kOwnParameters };
enum LocalStepChoice { kExact, kAdmm };

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

Status CubicLocalStep::prepare(const RestShape& rest, const Settings& settings) {
  prepareVertices(rest, settings);
  if (Status status = prepareStyle(settings); !status.ok()) return status;
  frames_.prepare(settings.scalars[kOrientation], settings.scalars[kFrames], rest.mesh.vertexCount());
  begin();
  return {};
}

void CubicLocalStep::prepareVertices(const RestShape& rest, const Settings& settings) {
  const Scalars& own = settings.scalars[kLambdaPerVertex];
  const auto cubeness = [&](Index v) { return own.size() ? own[v] : settings.numbers[kLambda]; };  // λ_i, Eq. 1
  const std::size_t batches = batchCount(rest.mesh.vertexCount());
  normals_.assign(batches, {splat(0), splat(0), splat(0)});
  weights_.assign(batches, splat(0));
  for (Index v = 0; v < rest.mesh.vertexCount(); ++v) {
    const Vec3 n = rest.normals.row(v).transpose();
    setVector(normals_[v / 4], v % 4, n);
    if (!n.isZero(0)) weights_[v / 4][v % 4] = static_cast<float>(cubeness(v) * rest.areas[v]);
  }
}

Status CubicLocalStep::prepareStyle(const Settings& settings) {
  const Scalars& rows = settings.scalars[kPolyhedron];
  const Vec3 lengths = settings.scalars[kLambdaAxes];
  const bool isCube = rows.size() == 0 && settings.numbers[kPolyhedron] == 0;
  if (!isCube && lengths != Vec3::Ones()) {
    return Status::failure(Code::badParameter,
                           "only the cube has axes to weigh; leave lambdaAxes at 1, 1, 1 or choose the polyhedron \"cube\"");
  }
  if (isCube) {
    polyhedron_ = Polyhedron::box(lengths);
  } else {
    polyhedron_ = rows.size() ? Polyhedron::ofRows(rows) : Polyhedron::named(static_cast<std::size_t>(settings.numbers[kPolyhedron]));
  }
  axes_ = Vec3::Ones();
  if (static_cast<int>(settings.numbers[kLocalStep]) == kAdmm) {
    solver_ = std::make_unique<CubicAdmm>(polyhedron_);
  } else if (isCube) {
    solver_ = std::make_unique<CubicExact>();
    axes_ = lengths;
  } else {
    solver_ = std::make_unique<PolyhedralExact>(polyhedron_);
  }
  return {};
}

Lanes CubicLocalStep::fit(std::size_t batch, const MatrixLanes& covariances, bool neverWorse, QuaternionLanes& rotations) {
  if (frames_.areIdentity()) return solve(batch, covariances, neverWorse, rotations);
  const QuaternionLanes before = frames_.intoFrames(batch, rotations);
  QuaternionLanes after = before;
  const Lanes regularizers = solve(batch, frames_.covariances(batch, covariances), neverWorse, after);
  frames_.outOfFrames(batch, before, after, rotations);
  return regularizers;
}

Lanes CubicLocalStep::solve(std::size_t batch, const MatrixLanes& M, bool neverWorse, QuaternionLanes& rotations) {
  const Lanes weights = weights_[batch];
  const VectorLanes axes{splat(static_cast<float>(axes_.x())), splat(static_cast<float>(axes_.y())), splat(static_cast<float>(axes_.z()))};
  const CubicLanes vertices{M, normals_[batch], {weights * axes.x, weights * axes.y, weights * axes.z}};
  const QuaternionLanes guess = rotations;
  Lanes regularizers = solver_->solve(batch, vertices, rotations);
  if (neverWorse) keepBetter(vertices, weights, polyhedron_, guess, rotations, regularizers);
  return regularizers;
}

MethodInfo cubicMethod() {
  const auto create = []() -> std::unique_ptr<Method> {
    return std::make_unique<LocalGlobal>(std::make_unique<CubicLocalStep>(), kOwnParameters);
  };
  return {"cubic",
          withSharedParameters({{"lambda", ParameterKind::number, Stale::weights, 0.2, 0, 100},
                                {"lambdaPerVertex", ParameterKind::scalars, Stale::weights, 0, 0, 100},
                                vectorParameter("lambdaAxes", Stale::weights, 3, 1, 0, 100),
                                choiceOrRowsParameter("polyhedron", Stale::weights, Polyhedron::names(), Polyhedron::kMostRows),
                                {"orientation", ParameterKind::rotation, Stale::weights},
                                {"frames", ParameterKind::rotations, Stale::weights},
                                choiceParameter("localStep", Stale::weights, {"exact", "admm"})}),
          create};
}

}  // namespace whittle
