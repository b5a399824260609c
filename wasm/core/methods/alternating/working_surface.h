#pragma once

#include <memory>
#include <optional>

#include "constraints/contact_search.h"
#include "methods/alternating/reshape_parameters.h"
#include "methods/alternating/structure.h"
#include "methods/stage.h"
#include "remeshing/transfer.h"

namespace whittle {

/// The surface that the solvers of a reshaping work on, and the way back to the mesh that it was made from. What depends
/// on the mesh alone is found once and kept while variants, readings and handles change.
class WorkingSurface {
 public:
  /// The stages that make it for these values, none where it is there already. Rest and values outlive them.
  void addStages(const TriangleMesh& rest, const ReshapeParameters& values, Plan& plan);

  const DerivedMesh& mesh() const { return working_; }
  const RestSurface& surface() const { return *surface_; }
  const Structure& structure() const { return structure_; }
  const Transfer& transfer() const { return *transfer_; }
  const FeatureSettings& features() const { return features_; }
  const std::vector<Attachment>& attachments() const { return attachments_; }
  /// A chain of the input's vertices on the working mesh, as far as it has them.
  std::vector<Index> chainOf(const std::vector<Index>& chain) const;

 private:
  void begin(const ReshapeParameters& values);
  void findTransfer(double& done);
  void measure(const ReshapeParameters& values);
  void findStructure(double& done);
  void findContacts(double& done);
  std::vector<bool> edgesOf(const VertexChains& chains) const;

  const TriangleMesh* rest_ = nullptr;
  DerivedMesh working_;
  std::optional<Transfer> transfer_;
  std::optional<RestSurface> surface_;
  FeatureSettings features_;
  Structure structure_;
  std::vector<Attachment> attachments_;
  std::unique_ptr<StructureSearch> search_;  // while it goes on
  std::unique_ptr<ContactSearch> contactSearch_;

  // What it was made for
  bool isMade_ = false;
  Remesh remesh_ = Remesh::automatic;
  double featureAngle_ = 0;
  VertexChains marked_, unmarked_;
};

}  // namespace whittle
