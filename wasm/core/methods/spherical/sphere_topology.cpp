#include "methods/spherical/sphere_topology.h"

#include <algorithm>
#include <string>
#include <tuple>
#include <vector>

#include "mesh/disjoint_sets.h"
#include "mesh/validate.h"

namespace whittle {

namespace {

/// An edge as a face passes it.
struct DirectedEdge {
  Index from, to, face;
  Index low() const { return std::min(from, to); }
  Index high() const { return std::max(from, to); }
};

std::vector<DirectedEdge> sortedEdges(const Triangles& triangles) {
  std::vector<DirectedEdge> edges;
  edges.reserve(3 * triangles.rows());
  for (Index f = 0; f < triangles.rows(); ++f) {
    for (int k = 0; k < 3; ++k) edges.push_back({triangles(f, k), triangles(f, (k + 1) % 3), f});
  }
  std::sort(edges.begin(), edges.end(), [](const DirectedEdge& a, const DirectedEdge& b) {
    return std::tuple(a.low(), a.high(), a.face) < std::tuple(b.low(), b.high(), b.face);
  });
  return edges;
}

std::string counted(Index count, const char* one, const char* many) {
  return std::to_string(count) + " " + (count == 1 ? one : many);
}

Status refuse(const std::string& message, Element element = {}) {
  return Status::failure(Code::unsuitableMesh, message, element);
}

/// Where a mesh is not what a sphere is made of: how many places, and the first.
struct Faults {
  Index count = 0;
  DirectedEdge first{-1, -1, -1};

  void add(const DirectedEdge& edge) {
    if (count++ == 0) first = edge;
  }
  Element vertex() const { return Element::vertex(first.from); }
  Element face() const { return Element::face(first.face); }
};

/// Every edge must have two faces that pass it in opposite directions.
Status requireClosed(const std::vector<DirectedEdge>& edges) {
  Faults open, crowded, turned;
  for (std::size_t e = 0, next = 0; e < edges.size(); e = next) {
    while (next < edges.size() && edges[next].low() == edges[e].low() && edges[next].high() == edges[e].high()) ++next;
    if (next - e == 1) open.add(edges[e]);
    if (next - e > 2) crowded.add(edges[e]);
    if (next - e == 2 && edges[e].from == edges[e + 1].from) turned.add(edges[e]);
  }
  if (open.count > 0) {
    return refuse("the surface is open along " + counted(open.count, "edge", "edges") +
                      ", the first at vertex {}; close its holes, only a closed surface can become a sphere",
                  open.vertex());
  }
  if (crowded.count > 0) {
    return refuse(
        counted(crowded.count, "edge joins", "edges join") +
            " three faces or more, the first at vertex {}; remove the inner faces so that one closed skin is left",
        crowded.vertex());
  }
  if (turned.count > 0) {
    return refuse("neighbouring faces disagree about the outside along " + counted(turned.count, "edge", "edges") +
                      ", the first at face {}; make the face directions consistent",
                  turned.face());
  }
  return {};
}

/// The faces around a vertex, linked across shared edges, must be one ring: it has a single part.
Status requireOneFan(const TriangleMesh& mesh, const std::vector<DirectedEdge>& edges) {
  // Corners (face, vertex) of one fan are joined by the two edges of a pair at both ends.
  DisjointSets fans(3 * mesh.faceCount());
  const auto corner = [&](Index face, Index vertex) {
    int k = 0;
    while (mesh.triangles(face, k) != vertex) ++k;
    return 3 * face + k;
  };
  for (std::size_t e = 0; e + 1 < edges.size(); e += 2) {
    for (const Index vertex : {edges[e].from, edges[e].to}) {
      fans.join(corner(edges[e].face, vertex), corner(edges[e + 1].face, vertex));
    }
  }
  std::vector<Index> fan(mesh.vertexCount(), -1);
  for (Index c = 0; c < static_cast<Index>(mesh.triangles.size()); ++c) {
    Index& known = fan[mesh.triangles(c / 3, c % 3)];
    if (known < 0) known = fans.find(c);
    if (known == fans.find(c)) continue;
    const Index vertex = mesh.triangles(c / 3, c % 3);
    return refuse("at vertex {} separate sheets touch in one point; split the vertex", Element::vertex(vertex));
  }
  return {};
}

Status requireGenusZero(const MeshReport& report) {
  const Index used = report.vertices - report.isolatedVertices;
  const Index edges = report.faces * 3 / 2;
  const Index genus = (2 - (used - edges + report.faces)) / 2;  // Euler: V − E + F = 2 − 2g
  if (genus == 0) return {};
  return refuse("the surface has " + counted(genus, "handle or tunnel", "handles or tunnels") + " (genus " +
                std::to_string(genus) + "); only a shape without, of genus 0, can become a sphere");
}

Status requireSoundFaces(const TriangleMesh& mesh, const MeshReport& report) {
  if (report.degenerateFaces == 0) return {};
  Index face = 0;
  while (thickness(mesh, face) > kDegenerateThickness) ++face;
  return refuse(counted(report.degenerateFaces, "face has", "faces have") +
                    " no area, the first is face {}; remove or remesh such faces",
                Element::face(face));
}

}  // namespace

Status requireSphere(const TriangleMesh& mesh) {
  const MeshReport report = inspect(mesh);
  if (report.components > 1) {
    return refuse("the mesh has " + std::to_string(report.components) +
                  " separate parts; keep one, or join them to one skin");
  }
  if (Status status = requireSoundFaces(mesh, report); !status.ok()) return status;
  const std::vector<DirectedEdge> edges = sortedEdges(mesh.triangles);
  if (Status status = requireClosed(edges); !status.ok()) return status;
  if (Status status = requireOneFan(mesh, edges); !status.ok()) return status;
  return requireGenusZero(report);
}

Index countFolded(const Triangles& triangles, const Points& positions, const Vec3& center) {
  Index outward = 0, inward = 0;
  for (Index f = 0; f < triangles.rows(); ++f) {
    const auto corner = [&](int k) -> Vec3 { return positions.row(triangles(f, k)).transpose() - center; };
    const double volume = corner(0).dot(corner(1).cross(corner(2)));
    outward += volume > 0;
    inward += volume < 0;
  }
  // A surface given inside out flows to a sphere inside out, which is as good.
  return static_cast<Index>(triangles.rows()) - std::max(outward, inward);
}

}  // namespace whittle
