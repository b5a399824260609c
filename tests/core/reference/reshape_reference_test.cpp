#include <doctest/doctest.h>

#include <string>

#include "methods/alternating/alternation.h"
#include "methods/alternating/reshape_terms.h"
#include "reference/plain_local_global.h"
#include "reference/plain_reshape.h"
#include "support/round_shapes.h"
#include "support/shapes.h"

using namespace whittle;
using namespace whittle::testing;

// The alternation as printed, against the same in plain Eigen: systems that are assembled and factored anew in double
// precision. Meshes are in the unit frame; distances are shares of the box.

namespace {

constexpr double kDegree = EIGEN_PI / 180;
/// How far the core may stray from the plain alternation in a run, as a share of the box: its solves end at a millionth
/// of what is left to do. Where a gesture folds faces over, inverses of nearly singular transformations amplify that.
constexpr double kSame = 1e-5;

/// A shape and what is asked of it.
struct Gesture {
  std::string name;
  TriangleMesh mesh;
  Handles handles;
};

/// All vertices at the two ends of an axis are held, those of the upper end moved along it and across.
Handles pulledApart(const TriangleMesh& mesh, int axis, double along, double across) {
  const double low = mesh.positions.col(axis).minCoeff(), high = mesh.positions.col(axis).maxCoeff();
  Handles handles;
  for (Index v = 0; v < mesh.vertexCount(); ++v) {
    const double place = mesh.positions(v, axis);
    if (place < low + 1e-6 || place > high - 1e-6) handles.vertices.push_back(v);
  }
  handles.targets.resize(static_cast<Index>(handles.vertices.size()), 3);
  for (Index h = 0; h < handles.targets.rows(); ++h) {
    handles.targets.row(h) = mesh.positions.row(handles.vertices[h]);
    if (handles.targets(h, axis) < high - 1e-6) continue;
    handles.targets(h, axis) += along;
    handles.targets(h, (axis + 1) % 3) += across;
  }
  return handles;
}

/// Half of a torus, open at both ends.
TriangleMesh halfTorus() {
  return sheet({14, 10, true, false}, [](double u, double v) {
    const double around = 2 * EIGEN_PI * u, along = EIGEN_PI * v, r = 1 + 0.35 * std::cos(around);
    return Vec3(r * std::cos(along), r * std::sin(along), -0.35 * std::sin(around));
  });
}

std::vector<Gesture> gestures() {
  std::vector<Gesture> all = {{"cylinder", cylinder(14, 9, 2, 0.8, 3, true), {}},
                              {"L", blocks({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, 4), {}},
                              {"half torus", halfTorus(), {}},
                              {"ball", sphere(3), {}}};
  for (Gesture& each : all) each.mesh = inUnitFrame(std::move(each.mesh));
  all[0].handles = pulledApart(all[0].mesh, 2, 0.4, 0.1);
  all[1].handles = pulledApart(all[1].mesh, 0, 0.3, 0.05);
  all[2].handles = pulledApart(all[2].mesh, 1, 0.1, 0.02);
  all[3].handles = pulledApart(all[3].mesh, 2, 0.2, 0.1);
  return all;
}

/// A surface with the terms of the printed method.
RestSurface surfaceOf(const TriangleMesh& mesh) {
  RestSurface surface = measureSurface(mesh);
  StructureSearch search(surface, {40 * kDegree, {}, {}});
  while (search.next() < 1) {
  }
  const Structure structure = search.take();
  setTerms(ReshapeTerms::of(Variant::slippage, Reading::published, Rung::full), structure, {}, surface);
  return surface;
}

PlainReshape plainOf(const RestSurface& surface, const Handles& handles) {
  PlainReshapeProblem problem{surface.mesh, surface.pairs, {}, surface.sphericity, handles};
  for (const Hinge& hinge : surface.hinges) problem.similarity.push_back(hinge.similarity);
  return PlainReshape(std::move(problem));
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

/// The alternation of the core on a surface, its inner solves as exact as they can be.
class Ours {
 public:
  Ours(const RestSurface& surface, const Handles& handles) {
    const EnergyWeights weights{.keptRadius = 0};
    vertices_.shape(surface, weights, rowsOf(handles));
    vertices_.assemble(restGoals(surface), Transformations(surface.faceCount(), Mat3::Identity()));
    vertices_.beginPrepare();
    for (double share = 0; share < 1;) REQUIRE(vertices_.prepareNext(share).ok());
    transformations_.shape(surface, weights);
    for (double share = 0; share < 1;) REQUIRE(transformations_.prepareNext(share).ok());
    AlternationLimits limits;
    limits.tolerance = 1e-6;
    limits.transformations = {1e-6, 3000};
    alternation_.begin(surface, weights, vertices_, transformations_, limits);
  }
  StepReport iterate() {
    StepReport report;
    do {
      REQUIRE(alternation_.iterate(report).ok());
    } while (report.outcome == Outcome::midway);
    return report;
  }
  const Points& positions() const { return alternation_.positions(); }

 private:
  VertexSystem vertices_;
  TransformationSystem transformations_;
  Alternation alternation_;
};

double largestMove(const Points& a, const Points& b) { return (a - b).rowwise().norm().maxCoeff(); }

/// The energy of the core by terms, from what each weight adds.
PlainReshape::Energies energiesOf(const RestSurface& surface, const EdgeGoals& goals, const Transformations& tau,
                                  const Points& positions) {
  using Plain = PlainReshape;
  RestSurface without = surface;
  without.sphericity.setZero();
  struct Sum {
    double ofVertices, ofTransformations;
  };
  const auto with = [&](const RestSurface& on, double normal, double similarity, double scale, double regularizer) {
    const EnergyWeights weights{normal, similarity, scale, regularizer, 0};
    TransformationSystem system;
    system.shape(on, weights);
    return Sum{vertexEnergy(on, weights, goals, tau, positions), system.energy(tau)};
  };
  const Sum bare = with(without, 0, 0, 0, 0);
  const auto added = [&](const Sum& sum) {
    return sum.ofVertices - bare.ofVertices + sum.ofTransformations - bare.ofTransformations;
  };
  PlainReshape::Energies energies{};
  energies[Plain::transform] = bare.ofVertices;
  energies[Plain::connect] = bare.ofTransformations;
  energies[Plain::normal] = added(with(without, 10, 0, 0, 0));
  energies[Plain::similarity] = added(with(without, 0, 1, 0, 0));
  energies[Plain::scale] = added(with(without, 0, 0, 1e-4, 0));
  energies[Plain::regularizer] = added(with(without, 0, 0, 0, 1e-4));
  energies[Plain::sphericity] = added(with(surface, 0, 0, 0, 0));
  return energies;
}

}  // namespace

TEST_CASE("reference: reshaping as printed goes the way of the plain alternation, and ends where that does") {
  for (const Gesture& each : gestures()) {
    CAPTURE(each.name);
    const RestSurface surface = surfaceOf(each.mesh);
    CHECK((surface.sphericity.maxCoeff() > 0.3) == (each.name == "ball"));
    PlainReshape plain = plainOf(surface, each.handles);
    Ours ours(surface, each.handles);
    for (bool goesOn = true; goesOn;) {
      goesOn = plain.iterate();
      const StepReport report = ours.iterate();
      CAPTURE(plain.iterations());
      const double difference = largestMove(ours.positions(), plain.positions());
      double energy = 0;
      for (const double term : plain.energies()) energy += term;
      CHECK(difference < kSame);
      CHECK(report.energy == doctest::Approx(energy).epsilon(1e-4));
      REQUIRE((report.outcome == Outcome::running) == goesOn);
    }
    CHECK(plain.isDefinite());
    CHECK(plain.iterations() >= 3);
  }
}

TEST_CASE("reference: each term of reshaping has the energy of the plain one") {
  for (const Gesture& each : gestures()) {
    CAPTURE(each.name);
    const RestSurface surface = surfaceOf(each.mesh);
    PlainReshape plain = plainOf(surface, each.handles);
    Points halfEdges = surface.halfEdges;
    for (int k = 0; k < 2; ++k) {
      EdgeGoals goals = restGoals(surface);
      Transformations tau;
      for (Index f = 0; f < surface.faceCount(); ++f) tau.push_back(plain.transformation(f));
      for (Index h = 0; h < goals.stress.size(); ++h)
        goals.stress[h] = stressOf(halfEdges.row(h).norm(), surface.averageLength);
      plain.solveVertices();
      REQUIRE(plain.judge());
      PlainReshape::Energies expected = energiesOf(surface, goals, tau, plain.positions());
      expected[PlainReshape::handles] = rowEnergy(rowsOf(each.handles), plain.positions());
      for (int term = 0; term < PlainReshape::kTerms; ++term) {
        CAPTURE(term);
        CHECK(plain.energies()[term] == doctest::Approx(expected[term]).epsilon(1e-6));
      }
      halfEdgeVectors(plain.positions(), surface.mesh.triangles, halfEdges);
      plain.solveTransformations();
    }
  }
}
