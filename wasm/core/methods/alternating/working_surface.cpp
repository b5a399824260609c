#include "methods/alternating/working_surface.h"

#include <algorithm>

#include "mesh/adjacency.h"

namespace whittle {

void WorkingSurface::addStages(const TriangleMesh& rest, const ReshapeParameters& values, Plan& plan) {
  rest_ = &rest;
  plan.add(Stale::all, "looking at the faces", 2, [this, &values] { begin(values); })
      .add(Stale::all, "finding the way back", 10, [this](double& done) { findTransfer(done); })
      .add(Stale::all, "measuring the shape", 10, [this, &values] { measure(values); })
      .add(Stale::all, "finding edges and round parts", 20, [this](double& done) { findStructure(done); })
      .add(Stale::all, "finding where parts touch", 3, [this](double& done) { findContacts(done); });
}

void WorkingSurface::begin(const ReshapeParameters& values) {
  if (isMade_ && remesh_ == values.remesh && featureAngle_ == values.featureAngle && marked_ == values.features &&
      unmarked_ == values.smooth)
    return;
  isMade_ = false;
  remesh_ = values.remesh;
  featureAngle_ = values.featureAngle;
  marked_ = values.features;
  unmarked_ = values.smooth;
  search_.reset();
  contactSearch_.reset();
  surface_.reset();
  working_ = DerivedMesh::same(*rest_);
  transfer_.emplace(*rest_, working_);
}

void WorkingSurface::findTransfer(double& done) {
  if (!isMade_) done = transfer_->next();
}

void WorkingSurface::measure(const ReshapeParameters&) {
  if (isMade_) return;
  surface_ = measureSurface(working_.mesh);
  const double degree = EIGEN_PI / 180;
  features_ = {featureAngle_ * degree, edgesOf(marked_), edgesOf(unmarked_)};
}

/// The edges of the working mesh along chains of the input's vertices, as far as it has them.
std::vector<bool> WorkingSurface::edgesOf(const VertexChains& chains) const {
  if (chains.empty()) return {};
  std::vector<bool> result(surface_->edges.count(), false);
  const auto& ends = surface_->edges.ends;
  for (const std::vector<Index>& chain : chains) {
    for (std::size_t i = 1; i < chain.size(); ++i) {
      const Index a = transfer_->place(chain[i - 1]).twin, b = transfer_->place(chain[i]).twin;
      const std::array<Index, 2> edge = {std::min(a, b), std::max(a, b)};
      const auto found = std::lower_bound(ends.begin(), ends.end(), edge);
      if (found != ends.end() && *found == edge) result[found - ends.begin()] = true;
    }
  }
  return result;
}

std::vector<Index> WorkingSurface::chainOf(const std::vector<Index>& chain) const {
  std::vector<Index> result;
  for (const Index v : chain) {
    if (const Index twin = transfer_->place(v).twin; twin >= 0) result.push_back(twin);
  }
  return result;
}

void WorkingSurface::findStructure(double& done) {
  if (isMade_) return;
  if (!search_) search_ = std::make_unique<StructureSearch>(*surface_, features_);
  done = search_->next();
  if (done < 1) return;
  structure_ = search_->take();
  search_.reset();
}

void WorkingSurface::findContacts(double& done) {
  if (isMade_) return;
  if (!contactSearch_) {
    contactSearch_ = std::make_unique<ContactSearch>(
        working_.mesh, partsByEdges(working_.mesh.triangles, working_.mesh.vertexCount()));
  }
  done = contactSearch_->next();
  if (done < 1) return;
  attachments_ = contactSearch_->take();
  contactSearch_.reset();
  isMade_ = true;
}

}  // namespace whittle
