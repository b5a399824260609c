#include "support/ablations.h"

#include <doctest/doctest.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <functional>

#include "methods/alternating/alternation.h"
#include "methods/alternating/reshape_terms.h"
#include "reference/plain_local_global.h"
#include "support/cad_shapes.h"
#include "support/round_shapes.h"
#include "support/shapes.h"

namespace whittle::testing {

namespace {

constexpr double kFeatures = 40 * EIGEN_PI / 180;
constexpr double kHandles = 1e5;

ReshapeTerms termsWithout(const std::string& without) {
  ReshapeTerms terms = ReshapeTerms::of(Variant::slippage, Reading::published, Rung::full);
  EnergyWeights& weights = terms.weights;
  if (without == "similarity") weights.similarity = 0;
  if (without == "sphericity") terms.spheres = ReshapeTerms::Spheres::none;
  if (without == "normal") weights.normal = 0;
  if (without == "size ×1000") weights.scale *= 1000;
  if (without == "size") weights.scale = 10 * weights.normal;
  return terms;
}

std::vector<PointRow> rowsOf(const Handles& handles) {
  std::vector<PointRow> rows;
  for (std::size_t h = 0; h < handles.vertices.size(); ++h) {
    PointRow row;
    row.stiffness = kHandles;
    row.add(handles.vertices[h], 1);
    row.target = handles.targets.row(static_cast<Index>(h)).transpose();
    rows.push_back(row);
  }
  return rows;
}

void keep(const std::string& name, const Points& positions, const Triangles& triangles) {
  const char* folder = std::getenv("WHITTLE_ABLATIONS");
  if (!folder) return;
  std::FILE* file = std::fopen((std::string(folder) + "/" + name + ".obj").c_str(), "w");
  REQUIRE(file);
  for (Index v = 0; v < positions.rows(); ++v)
    std::fprintf(file, "v %.9g %.9g %.9g\n", positions(v, 0), positions(v, 1), positions(v, 2));
  for (Index f = 0; f < triangles.rows(); ++f)
    std::fprintf(file, "f %d %d %d\n", triangles(f, 0) + 1, triangles(f, 1) + 1, triangles(f, 2) + 1);
  std::fclose(file);
}

/// A vertex that is nearest to a place, given by shares of the box.
Index vertexAt(const TriangleMesh& mesh, const Vec3& share) {
  const Vec3 low = mesh.positions.colwise().minCoeff().transpose();
  const Vec3 box = mesh.positions.colwise().maxCoeff().transpose() - low;
  Index nearest = 0;
  (mesh.positions.rowwise() - (low + share.cwiseProduct(box)).transpose()).rowwise().norm().minCoeff(&nearest);
  return nearest;
}

/// Handles hold one group of vertices and move another some way.
Handles pulled(const TriangleMesh& mesh, std::vector<Index> held, const std::vector<Index>& moved, const Vec3& way) {
  Handles handles;
  const Index first = static_cast<Index>(held.size());
  handles.vertices = std::move(held);
  handles.vertices.insert(handles.vertices.end(), moved.begin(), moved.end());
  handles.targets.resize(static_cast<Index>(handles.vertices.size()), 3);
  for (Index i = 0; i < handles.targets.rows(); ++i) {
    handles.targets.row(i) = mesh.positions.row(handles.vertices[i]);
    if (i >= first) handles.targets.row(i) += way.transpose();
  }
  return handles;
}

Handles pulledByPoints(const TriangleMesh& mesh, const Vec3& held, const Vec3& moved, const Vec3& way) {
  return pulled(mesh, {vertexAt(mesh, held)}, {vertexAt(mesh, moved)}, way);
}

Handles pulledByEnds(const TriangleMesh& mesh, int axis, double move) {
  const double low = mesh.positions.col(axis).minCoeff(), high = mesh.positions.col(axis).maxCoeff();
  std::vector<Index> held, moved;
  for (Index v = 0; v < mesh.vertexCount(); ++v) {
    if (mesh.positions(v, axis) < low + 1e-6) held.push_back(v);
    if (mesh.positions(v, axis) > high - 1e-6) moved.push_back(v);
  }
  return pulled(mesh, held, moved, move * Vec3::Unit(axis));
}

constexpr double kBall = 0.5, kRod = 0.2, kHalf = 1.6;

/// Radius and height along a pawn: the ball in the middle and half of a rod's length on either side.
std::vector<std::array<double, 2>> pawnProfile() {
  constexpr int kDisc = 3, kRows = 12, kArc = 20;
  const double foot = std::asin(kRod / kBall), joint = kBall * std::cos(foot);
  std::vector<std::array<double, 2>> profile;
  for (int k = 0; k <= kDisc; ++k) profile.push_back({kRod * k / kDisc, -kHalf});
  for (int k = 1; k < kRows; ++k) profile.push_back({kRod, -kHalf + (kHalf - joint) * k / kRows});
  for (int k = 0; k <= kArc; ++k) {
    const double angle = foot + (EIGEN_PI - 2 * foot) * k / kArc;
    profile.push_back({kBall * std::sin(angle), -kBall * std::cos(angle)});
  }
  for (int k = kRows - 1; k >= 1; --k) profile.push_back({kRod, kHalf - (kHalf - joint) * k / kRows});
  for (int k = kDisc; k >= 0; --k) profile.push_back({kRod * k / kDisc, kHalf});
  return profile;
}

}  // namespace

Points Ablation::run(const std::string& without) const {
  RestSurface surface = measureSurface(mesh);
  StructureSearch search(surface, {kFeatures, {}, {}});
  while (search.next() < 1) {
  }
  const ReshapeTerms terms = termsWithout(without);
  setTerms(terms, search.take(), {}, surface);
  VertexSystem vertices;
  vertices.shape(surface, terms.weights, rowsOf(handles));
  vertices.assemble(restGoals(surface), Transformations(surface.faceCount(), Mat3::Identity()));
  vertices.beginPrepare();
  for (double share = 0; share < 1;) REQUIRE(vertices.prepareNext(share).ok());
  TransformationSystem transformations;
  transformations.shape(surface, terms.weights);
  for (double share = 0; share < 1;) REQUIRE(transformations.prepareNext(share).ok());
  Alternation alternation;
  alternation.begin(surface, terms.weights, vertices, transformations, {});
  StepReport report;
  do {
    REQUIRE(alternation.iterate(report).ok());
  } while (report.outcome == Outcome::midway || report.outcome == Outcome::running);
  keep(name, mesh.positions, mesh.triangles);
  keep(name + ", " + without, alternation.positions(), mesh.triangles);
  return alternation.positions();
}

Ablation widenedColumn() {
  TriangleMesh mesh = inUnitFrame(cylinder(36, 24, 6, 0.5, 1.2, true));
  Handles handles = pulledByPoints(mesh, {1, 0.5, 0.5}, {0, 0.5, 0.5}, {-0.4, 0, 0});
  return {"column", std::move(mesh), std::move(handles)};
}

Ablation lengthenedPawn() {
  TriangleMesh mesh = inUnitFrame(revolved(pawnProfile(), 32, false));
  Handles handles = pulledByEnds(mesh, 2, 0.5);
  return {"pawn", std::move(mesh), std::move(handles)};
}

Ablation pulledBracket() {
  TriangleMesh mesh = inUnitFrame(blocks({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, 8));
  Handles handles = pulledByEnds(mesh, 0, 0.4);
  return {"bracket", std::move(mesh), std::move(handles)};
}

Ablation pulledBar() {
  TriangleMesh mesh = inUnitFrame(longBox(16, 8));
  Handles handles = pulledByPoints(mesh, {0, 0.5, 0.5}, {1, 0.5, 0.5}, {0.5, 0, 0});
  return {"bar", std::move(mesh), std::move(handles)};
}

std::vector<std::vector<Index>> ringsOf(const Points& column) {
  // Rings have heights of their own, and nothing else of a column has its radius.
  const Eigen::RowVector3d middle = (column.colwise().maxCoeff() + column.colwise().minCoeff()) / 2;
  const double radius = column.col(0).maxCoeff() - middle[0];
  std::vector<std::vector<Index>> rings;
  std::vector<double> heights;
  for (Index v = 0; v < column.rows(); ++v) {
    if (std::abs((column.row(v) - middle).head<2>().norm() - radius) > 1e-6) continue;
    std::size_t ring = 0;
    while (ring < heights.size() && std::abs(heights[ring] - column(v, 2)) > 1e-6) ++ring;
    if (ring == heights.size()) {
      heights.push_back(column(v, 2));
      rings.emplace_back();
    }
    rings[ring].push_back(v);
  }
  return rings;
}

std::vector<Index> ballVertices(const Points& pawn) {
  const Eigen::RowVector3d middle = (pawn.colwise().maxCoeff() + pawn.colwise().minCoeff()) / 2;
  const double radius = pawn.col(0).maxCoeff() - middle[0];
  std::vector<Index> on;
  for (Index v = 0; v < pawn.rows(); ++v) {
    if (std::abs((pawn.row(v) - middle).norm() - radius) < 1e-6) on.push_back(v);
  }
  return on;
}

}  // namespace whittle::testing
