#include "methods/local_global/cubic.h"

#include "geometry/rotation_fit.h"
#include "methods/local_global/cubic_admm.h"
#include "methods/local_global/cubic_exact.h"
#include "methods/local_global/local_global.h"
#include "methods/local_global/polyhedral_exact.h"

namespace whittle {

namespace {

enum Parameter { kLambda, kLambdaPerVertex, kPolyhedron, kLocalStep, kOwnParameters };
enum LocalStepChoice { kExact, kAdmm };

/// Goes back to the guess in lanes where it is better.
void keepBetter(const CubicLanes& vertices, const Polyhedron& polyhedron, const QuaternionLanes& guess, QuaternionLanes& rotations,
                Lanes& regularizers) {
  for (int lane = 0; lane < 4; ++lane) {
    const CubicVertex cubic = vertexAt(vertices, lane);
    const PolyhedralVertex vertex(cubic.M, cubic.n, cubic.weights.x(), polyhedron);
    const Mat3 before = rotationAt(guess, lane);
    if (vertex.objective(rotationAt(rotations, lane)) >= vertex.objective(before)) continue;
    setRotation(rotations, lane, before);
    regularizers[lane] = static_cast<float>(vertex.weight * polyhedron.support(before * vertex.n));
  }
}

}  // namespace

Status CubicLocalStep::prepare(const RestShape& rest, const Settings& settings) {
  const Scalars& own = settings.scalars[kLambdaPerVertex];
  const auto cubeness = [&](Index v) { return own.size() ? own[v] : settings.numbers[kLambda]; };  // λ_i, Eq. 1
  const std::size_t batches = batchCount(rest.mesh.vertexCount());
  normals_.assign(batches, {splat(0), splat(0), splat(0)});
  weights_ = normals_;
  for (Index v = 0; v < rest.mesh.vertexCount(); ++v) {
    const Vec3 n = rest.normals.row(v).transpose();
    setVector(normals_[v / 4], v % 4, n);
    if (!n.isZero(0)) setVector(weights_[v / 4], v % 4, Vec3::Constant(cubeness(v) * rest.areas[v]));
  }
  polyhedron_ = Polyhedron::named(static_cast<std::size_t>(settings.numbers[kPolyhedron]));
  if (static_cast<int>(settings.numbers[kLocalStep]) == kAdmm) {
    solver_ = std::make_unique<CubicAdmm>(polyhedron_);
  } else if (settings.numbers[kPolyhedron] == 0) {
    solver_ = std::make_unique<CubicExact>();
  } else {
    solver_ = std::make_unique<PolyhedralExact>(polyhedron_);
  }
  begin();
  return {};
}

Lanes CubicLocalStep::fit(std::size_t batch, const ScaledCovariances& covariances, bool neverWorse, QuaternionLanes& rotations) {
  const CubicLanes vertices{covariances.M, normals_[batch], splat(1) / covariances.scale * weights_[batch]};
  const QuaternionLanes guess = rotations;
  Lanes regularizers = solver_->solve(batch, vertices, rotations);
  if (neverWorse) keepBetter(vertices, polyhedron_, guess, rotations, regularizers);
  return covariances.scale * regularizers;
}

MethodInfo cubicMethod() {
  const auto create = []() -> std::unique_ptr<Method> {
    return std::make_unique<LocalGlobal>(std::make_unique<CubicLocalStep>(), kOwnParameters);
  };
  return {"cubic",
          withSharedParameters({{"lambda", ParameterKind::number, Stale::weights, 0.2, 0, 100},
                                {"lambdaPerVertex", ParameterKind::scalars, Stale::weights, 0, 0, 100},
                                choiceParameter("polyhedron", Stale::weights, Polyhedron::names()),
                                choiceParameter("localStep", Stale::weights, {"exact", "admm"})}),
          create};
}

}  // namespace whittle
