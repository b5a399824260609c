#include "methods/alternating/working_surface.h"

#include <algorithm>
#include <numeric>

#include "mesh/adjacency.h"
#include "methods/alternating/marked_lines.h"
#include "remeshing/clean.h"

namespace whittle {

namespace {

/// Creases that the faces are cut along; below the angle from which on the solvers see a feature (§7.6).
constexpr double kRemeshedFeatures = 35;

std::vector<std::array<Index, 2>> pairsOf(const VertexChains& chains, const DerivedMesh& mesh, Index originals) {
  std::vector<Index> placeOf(originals, -1);
  for (std::size_t v = 0; v < mesh.vertexOrigin.size(); ++v) {
    if (mesh.vertexOrigin[v] >= 0) placeOf[mesh.vertexOrigin[v]] = static_cast<Index>(v);
  }
  std::vector<std::array<Index, 2>> pairs;
  for (const std::vector<Index>& chain : chains) {
    for (std::size_t i = 1; i < chain.size(); ++i) {
      const std::array<Index, 2> pair = {placeOf[chain[i - 1]], placeOf[chain[i]]};
      if (pair[0] >= 0 && pair[1] >= 0) pairs.push_back(pair);
    }
  }
  return pairs;
}

}  // namespace

void WorkingSurface::addStages(const TriangleMesh& rest, const ReshapeParameters& values, Plan& plan) {
  rest_ = &rest;
  plan.add(Stale::all, "looking at the faces", 5, [this, &values] { begin(values); })
      .add(Stale::all, "cutting the faces anew", 30, [this](double& done) { remesh(done); })
      .add(Stale::all, "ordering the faces", 5, [this](double& done) { arrange(done); })
      .add(Stale::all, "finding the way back", 5, [this](double& done) { findTransfer(done); })
      .add(Stale::all, "measuring the shape", 3, [this] { measure(); })
      .add(Stale::all, "finding edges and round parts", 10, [this](double& done) { findStructure(done); })
      .add(Stale::all, "finding where parts touch", 3, [this](double& done) { findContacts(done); })
      .add(Stale::all, "tying parts together", 3, [this](double& done) { findScaffold(done); });
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
  scaffoldSearch_.reset();
  remesher_.reset();
  ordering_.reset();
  transfer_.reset();
  surface_.reset();

  lineRemarks_ = linesOffEdges("features", marked_, *rest_);
  const std::vector<std::string> ofSmooth = linesOffEdges("smooth", unmarked_, *rest_);
  lineRemarks_.insert(lineRemarks_.end(), ofSmooth.begin(), ofSmooth.end());
  CleanMesh clean = whittle::clean(*rest_);
  working_ = std::move(clean.derived);
  mended_ = clean.mended;
  unmended_ = static_cast<Index>(clean.unmended.size());
  cause_ = remesh_ == Remesh::never ? RemeshCause::none : needsRemeshing(working_.mesh);
  isRemeshed_ = remesh_ == Remesh::always || cause_ != RemeshCause::none;
  if (!isRemeshed_) return;
  remesher_ = std::make_unique<Remesher>(
      working_.mesh, RemeshSettings{.edge = remeshedEdge(working_.mesh, kRemeshedFeatures),
                                    .featureAngle = kRemeshedFeatures,
                                    .creases = pairsOf(marked_, working_, rest_->vertexCount()),
                                    .smoothEdges = pairsOf(unmarked_, working_, rest_->vertexCount())});
}

void WorkingSurface::remesh(double& done) {
  if (!remesher_) return;
  done = remesher_->next();
  if (done < 1) return;
  CleanMesh remeshed = remesher_->take();
  remesher_.reset();
  working_ = working_.then(std::move(remeshed.derived));
  unmended_ = static_cast<Index>(remeshed.unmended.size());  // long ones were cut into what is none
}

/// Lays what the loops read together side by side: vertices in an elimination order, faces by their vertices.
void WorkingSurface::arrange(double& done) {
  if (isMade_) return;
  if (isRemeshed_) {  // else the vertices come in such an order
    if (!ordering_) ordering_ = std::make_unique<VertexOrdering>(working_.mesh);
    done = ordering_->next();
    if (done < 1) return;
    const VertexOrder order = ordering_->take();
    ordering_.reset();
    working_.mesh = order.ordered(working_.mesh);
    std::vector<Index> origin(working_.vertexOrigin.size());
    for (Index place = 0; place < working_.mesh.vertexCount(); ++place)
      origin[place] = working_.vertexOrigin[order.vertexAt(place)];
    working_.vertexOrigin = std::move(origin);
  }
  std::vector<Index> faces(working_.mesh.faceCount());
  std::iota(faces.begin(), faces.end(), 0);
  const Triangles triangles = working_.mesh.triangles;
  const std::vector<Index> origin = working_.faceOrigin;
  const Eigen::VectorXi first = triangles.rowwise().minCoeff();
  std::stable_sort(faces.begin(), faces.end(), [&](Index f, Index g) { return first[f] < first[g]; });
  for (Index f = 0; f < working_.mesh.faceCount(); ++f) {
    working_.mesh.triangles.row(f) = triangles.row(faces[f]);
    working_.faceOrigin[f] = origin[faces[f]];
  }
}

void WorkingSurface::findTransfer(double& done) {
  if (isMade_) return;
  if (!transfer_) transfer_.emplace(*rest_, working_);
  done = transfer_->next();
}

void WorkingSurface::measure() {
  if (isMade_) return;
  surface_ = measureSurface(working_.mesh);
  const double degree = EIGEN_PI / 180;
  features_ = {featureAngle_ * degree, edgesAlong(marked_, rest_->positions, *surface_),
               edgesAlong(unmarked_, rest_->positions, *surface_)};
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
  const TriangleMesh& mesh = working_.mesh;
  if (!contactSearch_) {
    contactSearch_ = std::make_unique<ContactSearch>(
        mesh, connectedComponents(mesh.triangles, mesh.vertexCount()).ofFaces(mesh.triangles));
  }
  done = contactSearch_->next();
  if (done < 1) return;
  attachments_ = contactSearch_->take();
  contactSearch_.reset();
}

/// Parts that touch are tied there already: the scaffold joins what is apart.
void WorkingSurface::findScaffold(double& done) {
  if (isMade_) return;
  const TriangleMesh& mesh = working_.mesh;
  if (!scaffoldSearch_) {
    const Components groups = Attachments(attachments_).tied(connectedComponents(mesh.triangles, mesh.vertexCount()));
    std::vector<Index> groupOf(mesh.vertexCount(), -1);
    bool areSeveral = false;
    for (Index f = 0; f < mesh.faceCount(); ++f) {
      for (int k = 0; k < 3; ++k) groupOf[mesh.triangles(f, k)] = groups.ofVertex[mesh.triangles(f, k)];
      areSeveral = areSeveral || groupOf[mesh.triangles(f, 0)] != groupOf[mesh.triangles(0, 0)];
    }
    scaffold_ = {};
    isMade_ = !areSeveral;
    if (isMade_) return;
    scaffoldSearch_ = std::make_unique<ScaffoldSearch>(mesh.positions, std::move(groupOf));
  }
  done = scaffoldSearch_->next();
  if (done < 1) return;
  scaffold_ = scaffoldSearch_->take();
  scaffoldSearch_.reset();
  isMade_ = true;
}

Scalars WorkingSurface::onInput(const Scalars& ofFaces) const {
  const TriangleMesh& mesh = working_.mesh;
  Scalars sums = Scalars::Zero(mesh.vertexCount()), counts = sums;
  for (Index f = 0; f < mesh.faceCount(); ++f) {
    for (int k = 0; k < 3; ++k) {
      sums[mesh.triangles(f, k)] += ofFaces[f];
      ++counts[mesh.triangles(f, k)];
    }
  }
  const Scalars means = sums.cwiseQuotient(counts.cwiseMax(1));
  Scalars result(rest_->vertexCount());
  for (Index v = 0; v < result.size(); ++v) {
    const Transfer::Place& place = transfer_->place(v);
    result[v] = place.twin >= 0 ? means[place.twin] : 0;
    for (int k = 0; k < 3 && place.twin < 0 && place.face >= 0; ++k)
      result[v] += place.weights[k] * means[mesh.triangles(place.face, k)];
  }
  return result;
}

std::vector<Index> WorkingSurface::linesOnInput(const std::vector<bool>& edges) const {
  VertexChains chains;
  for (Index e = 0; e < surface_->edges.count(); ++e) {
    if (edges[e]) chains.push_back({surface_->edges.ends[e][0], surface_->edges.ends[e][1]});
  }
  return linesOnInput(chains);
}

/// A chain goes on past vertices that the input does not have.
std::vector<Index> WorkingSurface::linesOnInput(const VertexChains& chains) const {
  std::vector<Index> lines;
  for (const std::vector<Index>& chain : chains) {
    Index last = -1;
    for (const Index v : chain) {
      const Index own = working_.vertexOrigin[v];
      if (own < 0) continue;
      if (last >= 0) lines.insert(lines.end(), {last, own});
      last = own;
    }
  }
  return lines;
}

std::vector<std::string> WorkingSurface::remarks() const {
  std::vector<std::string> remarks;
  if (isRemeshed_) {
    const char* const why = cause_ == RemeshCause::slivers       ? "many faces are slivers"
                            : cause_ == RemeshCause::unevenEdges ? "edges are of very different lengths"
                            : cause_ == RemeshCause::coarseness  ? "faces are too coarse to bend"
                                                                 : "that was asked for";
    remarks.push_back("The shape was worked out on " + std::to_string(working_.mesh.faceCount()) + " even faces, as " +
                      why + "; your own faces follow them.");
  }
  if (!isRemeshed_ && mended_ > 0) {
    remarks.push_back(mended_ == 1
                          ? "1 face that is too thin or repeats another is left out of the work; it follows the "
                            "rest."
                          : std::to_string(mended_) +
                                " faces that are too thin or repeat others are left out of the work; they "
                                "follow the rest.");
  }
  if (unmended_ > 0) {
    remarks.push_back(std::to_string(unmended_) +
                      " faces are so thin that they have no direction; where they are the result may be uneven.");
  }
  remarks.insert(remarks.end(), lineRemarks_.begin(), lineRemarks_.end());
  return remarks;
}

}  // namespace whittle
