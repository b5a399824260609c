#include "bench/reshape_solvers.h"

#include "linear/sparse_cholesky.h"
#include "mesh/unit_frame.h"
#include "methods/alternating/reshape_terms.h"
#include "methods/alternating/transformation_system.h"
#include "methods/alternating/vertex_system.h"

namespace whittle::bench {

namespace {

constexpr double kVertexTolerance = 1e-3;

Points centroids(const TriangleMesh& mesh) {
  Points points = Points::Zero(mesh.faceCount(), 3);
  for (Index f = 0; f < mesh.faceCount(); ++f) {
    for (int k = 0; k < 3; ++k) points.row(f) += mesh.positions.row(mesh.triangles(f, k)) / 3;
  }
  return points;
}

std::vector<PointRow> rowsOf(const Handles& handles) {
  std::vector<PointRow> rows;
  for (std::size_t h = 0; h < handles.vertices.size(); ++h) {
    PointRow row;
    row.stiffness = 1e5;
    row.add(handles.vertices[h], 1);
    row.target = handles.targets.row(static_cast<Index>(h)).transpose();
    rows.push_back(row);
  }
  return rows;
}

/// The state of the plain alternation before its third vertex solve.
struct State {
  Points positions;
  Transformations transformations;
  EdgeGoals goals;
};

State stateOf(const PlainReshape& plain, const RestSurface& surface) {
  State state{plain.positions(), {}, restGoals(surface)};
  Points halfEdges(surface.halfEdgeCount(), 3);
  halfEdgeVectors(state.positions, surface.mesh.triangles, halfEdges);
  for (Index f = 0; f < surface.faceCount(); ++f) state.transformations.push_back(plain.transformation(f));
  state.goals.targetLengths.setZero();
  for (Index h = 0; h < surface.halfEdgeCount(); ++h) {
    const Index e = surface.edges.ofHalfEdge[h];
    const double share = (plain.transformation(faceOf(h)) * surface.halfEdges.row(h).transpose()).norm();
    for (Index place = surface.edges.start[e]; place < surface.edges.start[e + 1]; ++place)
      state.goals.targetLengths[surface.edges.halfEdges[place]] += share / surface.edges.faceCountAt(e);
    state.goals.stress[h] = stressOf(halfEdges.row(h).norm(), surface.averageLength);
  }
  return state;
}

Json timeDirectTransformations(const PlainReshape& plain, const RestSurface& surface) {
  const PlainLeastSquares& system = plain.transformationSystem();
  const Points places = centroids(surface.mesh);
  SparseCholesky cholesky;
  const double analyzing = timed([&] { cholesky.analyze(system.matrix(), {.coordinates = &places, .blockSize = 9}); });
  const double factoring = timed([&] { require(cholesky.factorize(system.matrix())); });
  Scalars solution = system.rightHandSide();
  const double solving = timed([&] { cholesky.solve(solution); });
  return Json().add("prepare", analyzing + factoring).add("solve", solving);
}

/// @param before transformations of the iteration before
Json timeGradients(const State& state, Transformations before, const RestSurface& surface) {
  TransformationSystem system;
  const double preparing = timed([&] {
    system.shape(surface, {.keptRadius = 0});
    for (double share = 0; share < 1;) require(system.prepareNext(share));
  });
  Points halfEdges(surface.halfEdgeCount(), 3);
  halfEdgeVectors(state.positions, surface.mesh.triangles, halfEdges);
  const auto solve = [&](Transformations& start) {
    return timed([&] {
      system.beginSolve(halfEdges, {}, start);
      while (!system.solveNext()) {
      }
    });
  };
  Transformations cold(surface.faceCount(), Mat3::Identity());
  return Json().add("prepare", preparing).add("cold", solve(cold)).add("solve", solve(before));
}

Json timeBlocks(const SparseMatrix& first, const PlainReshape& later, const State& state, const RestSurface& surface) {
  const PlainLeastSquares& system = later.vertexSystem();
  SparseCholesky cholesky;
  const double preparing = timed([&] {
    cholesky.analyze(first, {.coordinates = &surface.mesh.positions, .blockSize = 3});
    require(cholesky.factorize(first));
  });
  const Scalars start = Eigen::Map<const Scalars>(state.positions.data(), state.positions.size());
  const Scalars residual = system.rightHandSide() - system.matrix().selfadjointView<Eigen::Lower>() * start;
  Scalars correction = Scalars::Zero(start.size());
  ConjugateGradients::Report report;
  const double solving = timed([&] {
    require(cholesky.solveRefined(system.matrix(), residual, correction, {kVertexTolerance, 300}, &report));
  });
  return Json().add("prepare", preparing).add("solve", solving).add("iterations", report.iterations);
}

Json timeMeans(const State& state, const RestSurface& surface, const Handles& handles) {
  VertexSystem system;
  const double preparing = timed([&] {
    system.shape(surface, {.keptRadius = 0}, rowsOf(handles));
    system.assemble(restGoals(surface), Transformations(surface.faceCount(), Mat3::Identity()));
    system.beginPrepare();
    for (double share = 0; share < 1;) require(system.prepareNext(share));
  });
  Points positions = state.positions;
  system.assemble(state.goals, state.transformations);
  const double solving = timed([&] { require(system.solve(kVertexTolerance, positions)); });
  return Json().add("prepare", preparing).add("solve", solving);
}

}  // namespace

Gesture inUnitFrame(Gesture gesture) {
  const UnitFrame frame = UnitFrame::of(gesture.mesh);
  for (Points* points : {&gesture.mesh.positions, &gesture.handles.targets}) {
    for (Index v = 0; v < points->rows(); ++v) points->row(v) = frame.toUnit(points->row(v).transpose()).transpose();
  }
  return gesture;
}

RestSurface printedSurface(const TriangleMesh& mesh) {
  RestSurface surface = measureSurface(mesh);
  StructureSearch search(surface, {});
  while (search.next() < 1) {
  }
  setTerms(ReshapeTerms::of(Variant::slippage, Reading::published, Rung::full), search.take(), {}, surface);
  return surface;
}

PlainReshape plainOn(const RestSurface& surface, const Handles& handles) {
  PlainReshapeProblem problem{surface.mesh, surface.pairs, {}, surface.sphericity, handles};
  for (const Hinge& hinge : surface.hinges) problem.similarity.push_back(hinge.similarity);
  return PlainReshape(std::move(problem));
}

Json measureSolvers(const Gesture& given) {
  const Gesture gesture = inUnitFrame(given);
  const RestSurface surface = printedSurface(gesture.mesh);
  PlainReshape plain = plainOn(surface, gesture.handles);
  plain.iterate();
  const SparseMatrix first = plain.vertexSystem().matrix();
  const Transformations before = stateOf(plain, surface).transformations;
  plain.iterate();
  const State state = stateOf(plain, surface);
  plain.solveVertices();
  return Json()
      .add("direct", timeDirectTransformations(plain, surface))
      .add("gradients", timeGradients(state, before, surface))
      .add("blocks", timeBlocks(first, plain, state, surface))
      .add("means", timeMeans(state, surface, gesture.handles));
}

}  // namespace whittle::bench
