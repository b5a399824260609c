#pragma once

#include <memory>
#include <optional>
#include <string>

#include "mesh/unit_frame.h"
#include "mesh/validate.h"
#include "methods/registry.h"
#include "methods/vertex_order.h"

namespace whittle {

/// One mesh, one method at a time and the positions so far: what the outside drives. Speaks the file's units; works in
/// the unit frame, on vertices in a `VertexOrder` that the first `prepare` finds. Every setter notes what it makes stale, `prepare`
/// recomputes just that.
class Session {
 public:
  /// Takes a mesh and reports on it; forgets everything else. Fails as `validate` does and then holds no mesh.
  Status load(TriangleMesh mesh);
  const MeshReport& report() const { return report_; }

  /// Chooses a method; its parameters get their defaults unless it was chosen already. Fails with `unknownMethod`.
  Status select(const std::string& method);
  /// A number, a choice by the index of its name or a flag as 0 or 1. Fails with `badParameter`.
  Status setNumber(const std::string& parameter, double value);
  /// A list of numbers as its kind has it: for each vertex one, or a quaternion x y z w, or none; a vector; a quaternion; the rows of
  /// a matrix that take the place of a choice, or none. Fails with `badParameter`.
  Status setScalars(const std::string& parameter, const Scalars& values);
  /// A Gauss map, or none. Fails with `badParameter`.
  Status setStyle(const std::string& parameter, const std::optional<GaussMapData>& data);
  /// A texture's slopes, or none. Fails with `badParameter` or `unsuitableMesh`.
  Status setTextureSlopes(const std::string& parameter, std::optional<TextureSlopes> slopes);
  /// Targets in the file's units. Fails with `badHandles`.
  Status setHandles(Handles handles);

  /// Back to the rest positions.
  void restart();
  /// Recomputes what is stale and starts a run from the current positions. Fails with `numericalFailure`, or as the method refuses
  /// the mesh or its settings.
  Status prepare();
  /// One iteration of a prepared run. Fails with `numericalFailure`; the positions are then those before the step.
  Status step(StepReport& report);

  /// Writes the current positions (#V×3) in the file's frame. A vertex that has not moved has its very own bits.
  void copyPositions(double* into) const;

 private:
  Status requireMethod() const;
  /// Finds the place of a parameter in the method's list, of one that `fits`. Fails with `badParameter`.
  template <typename Fits>
  Status find(const std::string& parameter, Fits fits, std::size_t& place) const;
  void orderVertices();
  void markStale(Stale level) { stale_ = std::max(stale_, level); }

  Points filePositions_;  // #V×3, as loaded
  TriangleMesh rest_;     // in the unit frame, by `vertexOrder_`
  UnitFrame frame_;
  VertexOrder vertexOrder_;
  MeshReport report_;

  const MethodInfo* info_ = nullptr;
  std::unique_ptr<Method> method_;
  Settings settings_;
  Stale stale_ = Stale::all;

  Points positions_;  // in the unit frame, by `vertexOrder_`
};

}  // namespace whittle
