#include <doctest/doctest.h>

#include <cmath>

#include "geometry/cotangent.h"
#include "geometry/rotation_fit.h"
#include "geometry/surface.h"
#include "support/shapes.h"
#include "support/style_runs.h"

using namespace whittle;
using namespace whittle::testing;

namespace {

const std::string kArap = "arap", kFarap = "farap", kAcap = "acap";
const std::string kAll[] = {kArap, kFarap, kAcap};

/// The mesh in the frame in which the core computes.
TriangleMesh inUnitFrame(TriangleMesh mesh) {
  const UnitFrame frame = UnitFrame::of(mesh);
  for (Index v = 0; v < mesh.vertexCount(); ++v) {
    mesh.positions.row(v) = frame.toUnit(mesh.positions.row(v).transpose()).transpose();
  }
  return mesh;
}

/// A smooth mesh and one with sharp edges, of which most vertices have several normals.
std::vector<TriangleMesh> meshes() {
  return {inUnitFrame(bent(sphere(2))), inUnitFrame(bent(blocks({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, 2)))};
}

/// An edge set, straight from the definition: c, d, u of all edges that element k sees, and of each of its normals area
/// and target. A face has one normal, a vertex one for each smooth fan.
struct PlainElement {
  struct Normal {
    double weight;  // λ a
    Vec3 n, t;
  };
  std::vector<double> c;
  std::vector<Vec3> d, u;
  std::vector<Normal> normals;
};

std::vector<PlainElement> plainElements(const TriangleMesh& rest, const Points& output, const Analogy& analogy) {
  const bool perFace = analogy.regularizer == kFarap;
  const CornerScalars half = halfCotangents(rest.positions, rest.triangles);
  const SmoothFans fans = smoothFans(rest.positions, rest.triangles);
  const auto normalsOf = [&](const Points& positions) {
    return perFace ? faceNormals(positions, rest.triangles) : fanNormals(positions, rest.triangles, fans);
  };
  const Points normals = normalsOf(rest.positions), seen = analogy.isDynamic ? normalsOf(output) : normals;
  const Scalars areas =
      perFace ? faceAreas(rest.positions, rest.triangles) : mixedVoronoiAreas(rest.positions, rest.triangles, fans);
  const GaussMap style(analogy.style);
  std::vector<PlainElement> elements(perFace ? rest.faceCount() : rest.vertexCount());
  for (Index f = 0; f < rest.faceCount(); ++f) {
    for (int visit = 0; visit < (perFace ? 1 : 3); ++visit) {
      PlainElement& element = elements[perFace ? f : rest.triangles(f, visit)];
      for (int k = 0; k < 3; ++k) {
        const Index from = rest.triangles(f, (k + 1) % 3), to = rest.triangles(f, (k + 2) % 3);
        element.c.push_back(half(f, k));
        element.d.push_back((rest.positions.row(to) - rest.positions.row(from)).transpose());
        element.u.push_back((output.row(to) - output.row(from)).transpose());
      }
    }
  }
  const Scalars& own = analogy.lambdaPerVertex;
  for (Index k = 0; k < static_cast<Index>(elements.size()); ++k) {
    double lambda = analogy.lambda;
    if (own.size())
      lambda =
          perFace ? (own[rest.triangles(k, 0)] + own[rest.triangles(k, 1)] + own[rest.triangles(k, 2)]) / 3 : own[k];
    const Index first = perFace ? k : fans.start[k], end = perFace ? k + 1 : fans.start[k + 1];
    for (Index i = first; i < end; ++i)
      elements[k].normals.push_back({lambda * areas[i], normals.row(i).transpose(), style(seen.row(i).transpose())});
  }
  return elements;
}

double energyOf(const PlainElement& e, const Mat3& R, double s) {
  double energy = 0;
  for (const auto& [weight, n, t] : e.normals) energy += weight * (s * R * n - t).squaredNorm();
  for (std::size_t i = 0; i < e.c.size(); ++i) energy += e.c[i] * (s * R * e.d[i] - e.u[i]).squaredNorm();
  return energy;
}

Mat3 bestRotation(const PlainElement& e) {
  Mat3 M = Mat3::Zero();
  for (const auto& [weight, n, t] : e.normals) M += weight * n * t.transpose();
  for (std::size_t i = 0; i < e.c.size(); ++i) M += e.c[i] * e.d[i] * e.u[i].transpose();
  return fitRotation(M);
}

/// The best scale, by golden section.
double bestScale(const PlainElement& e, const Mat3& R) {
  double low = 1e-3, high = 10;
  const double ratio = (std::sqrt(5.0) - 1) / 2;
  for (int step = 0; step < 100; ++step) {
    const double a = high - ratio * (high - low), b = low + ratio * (high - low);
    (energyOf(e, R, a) < energyOf(e, R, b) ? high : low) = energyOf(e, R, a) < energyOf(e, R, b) ? b : a;
  }
  return (low + high) / 2;
}

/// The energy of an output for its best rotations and scales.
double plainEnergy(const TriangleMesh& rest, const Points& output, const Analogy& analogy) {
  double energy = 0;
  for (const PlainElement& e : plainElements(rest, output, analogy)) {
    const Mat3 R = bestRotation(e);
    energy += energyOf(e, R, analogy.regularizer == kAcap ? bestScale(e, R) : 1);
  }
  return energy;
}

/// Runs some steps and looks at the energy that the next one reports and at the output it is of.
struct Halfway {
  Points output;
  double energy = 0;
};

Halfway halfway(const TriangleMesh& unit, Analogy analogy, int steps) {
  analogy.acceleration = "none";  // what is reported is then the energy of what the step before gave
  Session session;
  REQUIRE(session.load(unit).ok());
  prepareAnalogy(session, analogy);
  StepReport report;
  for (int step = 0; step < steps; ++step) REQUIRE(session.step(report).ok());
  Halfway result{Points(unit.vertexCount(), 3)};
  session.copyPositions(result.output.data());
  REQUIRE(session.step(report).ok());
  result.energy = report.energy;
  return result;
}

}  // namespace

TEST_CASE("the reported energy is the one of the definition, and the global step is its descent") {
  Noise noise;
  for (const TriangleMesh& unit : meshes()) {
    Scalars own(unit.vertexCount());
    for (Index v = 0; v < own.size(); ++v) own[v] = 1 + noise();
    for (const std::string& regularizer : kAll) {
      for (const bool isDynamic : {false, true}) {
        for (const Scalars& lambdaPerVertex : {Scalars(), own}) {
          const Analogy analogy{cubeStyle(), 0.7, regularizer, isDynamic, 0, 300, "none", {}, lambdaPerVertex};
          for (const int steps : {0, 4}) {
            const Halfway at = halfway(unit, analogy, steps);
            CHECK(at.energy == doctest::Approx(plainEnergy(unit, at.output, analogy)).epsilon(1e-6));
          }
        }
      }
    }
  }
}

TEST_CASE("the global step is where the energy of these rotations and scales has no slope") {
  for (const TriangleMesh& unit : meshes()) {
    for (const std::string& regularizer : kAll) {
      Analogy analogy{octahedronStyle(), 1.3, regularizer};
      const Points from = halfway(unit, analogy, 3).output, to = halfway(unit, analogy, 4).output;
      std::vector<PlainElement> fitted = plainElements(unit, from, analogy), moved = plainElements(unit, to, analogy);
      const auto energyAt = [&](const Points& output) {
        const std::vector<PlainElement> here = plainElements(unit, output, analogy);
        double energy = 0;
        for (std::size_t k = 0; k < here.size(); ++k) {
          const Mat3 R = bestRotation(fitted[k]);
          energy += energyOf(here[k], R, regularizer == kAcap ? bestScale(fitted[k], R) : 1);
        }
        return energy;
      };
      Noise noise;
      for (int trial = 0; trial < 4; ++trial) {
        Points direction(unit.vertexCount(), 3);
        for (Index i = 0; i < direction.size(); ++i) direction.data()[i] = noise();
        constexpr double kStep = 1e-4;
        const auto slopeAt = [&](const Points& output) {
          return (energyAt(output + kStep * direction) - energyAt(output - kStep * direction)) / (2 * kStep);
        };
        CHECK(std::abs(slopeAt(to)) < 1e-4 * direction.norm());
      }
    }
  }
}
