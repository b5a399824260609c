#pragma once

#include <memory>
#include <optional>
#include <string>

#include "constraints/contact_search.h"
#include "methods/alternating/reshape_parameters.h"
#include "methods/alternating/structure.h"
#include "methods/stage.h"
#include "methods/vertex_order.h"
#include "remeshing/remesh_rule.h"
#include "remeshing/remesher.h"
#include "remeshing/scaffold.h"
#include "remeshing/transfer.h"

namespace whittle {

/// The surface that the solvers of a reshaping work on, and the way back to the mesh that it was made from: without
/// slivers, cut anew where faces are too uneven to say how the surface runs (§5.1), with what ties its parts. What
/// depends on the mesh alone is found once and kept while variants, readings and handles change.
class WorkingSurface {
 public:
  /// Adds the stages that make it for these values; they do nothing where it is there already. Rest and values outlive
  /// them.
  void addStages(const TriangleMesh& rest, const ReshapeParameters& values, Plan& plan);

  const DerivedMesh& mesh() const { return working_; }
  const RestSurface& surface() const { return *surface_; }
  const Structure& structure() const { return structure_; }
  const Transfer& transfer() const { return *transfer_; }
  const FeatureSettings& features() const { return features_; }
  const std::vector<Attachment>& attachments() const { return attachments_; }
  const Scaffold& scaffold() const { return scaffold_; }
  /// A number for each face of the surface as one for each vertex of the input, #V: the mean of its faces' there.
  Scalars onInput(const Scalars& ofFaces) const;
  /// Edges of the surface between vertices that the input has too: two vertices each.
  std::vector<Index> linesOnInput(const std::vector<bool>& edges) const;
  std::vector<Index> linesOnInput(const VertexChains& chains) const;
  /// Whether a vertex of the input moves with the surface; without faces it moves as a handle only.
  bool carries(Index vertex) const {
    const Transfer::Place& place = transfer_->place(vertex);
    return place.twin >= 0 || place.face >= 0;
  }
  /// Whether its faces are others than the input's.
  bool isOther() const { return isRemeshed_ || mended_ > 0; }
  /// What was done to the faces, and which marked lines mark nothing, a sentence each.
  std::vector<std::string> remarks() const;

 private:
  void begin(const ReshapeParameters& values);
  void remesh(double& done);
  void arrange(double& done);
  void findTransfer(double& done);
  void measure();
  void findStructure(double& done);
  void findContacts(double& done);
  void findScaffold(double& done);

  const TriangleMesh* rest_ = nullptr;
  DerivedMesh working_;
  std::optional<Transfer> transfer_;
  std::optional<RestSurface> surface_;
  FeatureSettings features_;
  Structure structure_;
  std::vector<Attachment> attachments_;
  Scaffold scaffold_;
  RemeshCause cause_ = RemeshCause::none;  // why it was cut anew
  bool isRemeshed_ = false;
  Index mended_ = 0, unmended_ = 0;  // slivers
  std::vector<std::string> lineRemarks_;

  // While they go on
  std::unique_ptr<Remesher> remesher_;
  std::unique_ptr<VertexOrdering> ordering_;
  std::unique_ptr<StructureSearch> search_;
  std::unique_ptr<ContactSearch> contactSearch_;
  std::unique_ptr<ScaffoldSearch> scaffoldSearch_;

  // What it was made for
  bool isMade_ = false;
  Remesh remesh_ = Remesh::automatic;
  double featureAngle_ = 0;
  VertexChains marked_, unmarked_;
};

}  // namespace whittle
