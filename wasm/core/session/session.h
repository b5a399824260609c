#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "mesh/unit_frame.h"
#include "mesh/validate.h"
#include "methods/registry.h"
#include "methods/vertex_order.h"
#include "session/preparation.h"

namespace whittle {

/// One mesh, one method at a time and the positions so far: what the outside drives. Speaks the file's units and, of
/// elements, the file's numbers; works in the unit frame, on vertices in a `VertexOrder` that the first preparation
/// finds. Setting a value notes what it makes stale, preparing recomputes just that.
class Session {
 public:
  Session() = default;
  /// Methods and stages know where it lies.
  Session(const Session&) = delete;

  /// Takes a mesh and reports on it; forgets everything else. Fails as `validate` does and then holds no mesh.
  /// @param sourceVertices #V, the number that the file has for each vertex; empty where it is the same
  /// @param sourceFaces #F, likewise of each face
  Status load(TriangleMesh mesh, std::vector<Index> sourceVertices = {}, std::vector<Index> sourceFaces = {});
  const MeshReport& report() const { return report_; }

  /// Chooses a method; its parameters get their defaults unless it was chosen already. Fails with `unknownMethod`.
  Status select(const std::string& method);
  /// Sets a parameter of the method. Fails with `badParameter`, or as its kind does.
  Status set(const std::string& parameter, const RawValue& value);

  /// Back to the rest positions.
  void restart();

  /// Does one stage of recomputing what is stale, or some of it; when nothing is left, starts a run from the current
  /// positions. A value that is set in between makes stages be done again only if they read it. Fails with
  /// `numericalFailure`, or as the method refuses the mesh or its values; the next call then begins with the stage that
  /// failed, or with one before it.
  /// @param share how far it is, 0 to 1; 1: prepared
  Status prepareNext(double& share);
  /// Does all stages.
  Status prepare();
  /// What the next call of `prepareNext` does, in a few words for people; "" where nothing is to be prepared.
  const char* stage();

  /// One iteration of a prepared run, or a part of one (`Outcome::midway`). Fails with `numericalFailure`; the positions are then those before the step.
  Status step(StepReport& report);

  /// What a person should know of the values on this mesh, a sentence each.
  std::vector<std::string> warnings() const;
  /// The fields that the prepared method can show.
  std::vector<Field> fields() const;
  /// Writes a field, #V or #F numbers in the order in which they were loaded. Fails with `badParameter` where there is
  /// none of this name.
  Status copyField(const std::string& name, double* into) const;

  /// Writes the current positions (#V×3) in the file's frame. A vertex that has not moved has its very own bits.
  void copyPositions(double* into) const;

 private:
  Session& operator=(Session&&) = default;
  /// Outside, elements have the numbers of the file: the one place where failures get them.
  Status inFileNumbers(const Status& status) const;
  Status requireMethod() const;
  void beginPreparing();
  Status refreshValues();
  Status acceptMesh() const;
  void orderVertices(double& done);
  void markStale(Stale level);

  Points filePositions_;               // #V×3, as loaded
  std::vector<Index> sourceVertices_;  // #V, or empty
  std::vector<Index> sourceFaces_;     // #F, or empty
  TriangleMesh rest_;                  // in the unit frame, by `vertexOrder_`
  UnitFrame frame_;
  VertexOrder vertexOrder_;
  MeshReport report_;

  const MethodInfo* info_ = nullptr;
  std::unique_ptr<Method> method_;
  std::unique_ptr<ParameterValues> values_;   // of vertices as they were loaded
  std::unique_ptr<ParameterValues> ordered_;  // by `vertexOrder_`: what the method sees
  bool isOrderedOld_ = true;                  // whether it is to be taken from `values_` again
  Stale stale_ = Stale::all;
  std::unique_ptr<VertexOrdering> ordering_;  // on its way to `vertexOrder_`
  std::optional<Preparation> preparation_;

  Points positions_;  // in the unit frame, by `vertexOrder_`
};

}  // namespace whittle
