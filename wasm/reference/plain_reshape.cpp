#include "reference/plain_reshape.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "geometry/surface.h"

namespace whittle {

namespace {

constexpr double kNormal = 10;
constexpr double kScale = 1e-4, kRegularizer = 1e-4;
constexpr double kHandles = 1e5, kStraight = 1e5;

const Mat3 I = Mat3::Identity();

/// ω, Eq. 20.
double stressOf(double length, double average) { return std::max(1.0, length / average * length / average); }

}  // namespace

PlainReshape::PlainReshape(PlainReshapeProblem problem)
    : problem_(std::move(problem)), edges_(problem_.mesh.triangles, problem_.mesh.vertexCount()),
      normals_(faceNormals(problem_.mesh.positions, problem_.mesh.triangles)),
      vertexSystem_(problem_.mesh.vertexCount()), transformationSystem_(3 * problem_.mesh.faceCount()) {
  const Index halfEdges = 3 * problem_.mesh.faceCount();
  V_ = problem_.mesh.positions;
  rest_.resize(halfEdges, 3);
  for (Index h = 0; h < halfEdges; ++h) rest_.row(h) = edgeOf(V_, h).transpose();
  restLengths_ = rest_.rowwise().norm();
  average_ = restLengths_.mean();
  tau_ = I.replicate(problem_.mesh.faceCount(), 1);
  targetLengths_ = restLengths_;
  stress_ = restLengths_.unaryExpr([this](double length) { return stressOf(length, average_); });
  bestEnergy_ = std::numeric_limits<double>::infinity();
}

Vec3 PlainReshape::edgeOf(const Points& positions, Index h) const {
  const auto corners = problem_.mesh.triangles.row(faceOf(h));
  return (positions.row(corners[headCorner(h)]) - positions.row(corners[tailCorner(h)])).transpose();
}

/// R about n̄: from the half edge that begins at a corner to the one that ends there, turned back.
Mat3 PlainReshape::cornerRotation(Index h) const {
  const Index last = 3 * faceOf(h) + oppositeCorner(h);
  const Vec3 to = rest_.row(h).transpose(), from = -rest_.row(last).transpose();
  const double angle = std::acos(std::clamp(to.normalized().dot(from.normalized()), -1.0, 1.0));
  return Eigen::AngleAxisd(angle, normals_.row(faceOf(h)).transpose()).toRotationMatrix();
}

double PlainReshape::lengthBetween(const Scalars& lengths, Index v, Index w) const {
  const std::array<Index, 2> ends = {std::min(v, w), std::max(v, w)};
  const auto edge = std::lower_bound(edges_.ends.begin(), edges_.ends.end(), ends) - edges_.ends.begin();
  return lengths[edges_.halfEdges[edges_.start[edge]]];
}

Scalars PlainReshape::presentLengths() const {
  Scalars lengths(restLengths_.size());
  for (Index h = 0; h < lengths.size(); ++h) lengths[h] = edgeOf(V_, h).norm();
  return lengths;
}

/// Eq. 20, 21, 35 and 23.
template <typename Visit>
void PlainReshape::visitVertexRows(const Scalars& lengths, Visit visit) const {
  for (Index h = 0; h < rest_.rows(); ++h) {
    const Index f = faceOf(h), last = 3 * f + oppositeCorner(h);
    const auto corners = problem_.mesh.triangles.row(f);
    const Index from = corners[tailCorner(h)], to = corners[headCorner(h)], other = corners[oppositeCorner(h)];
    const Vec3 e = rest_.row(h).transpose(), n = normals_.row(f).transpose();
    const double l = restLengths_[h];
    const Mat3 inverse = transformation(f).inverse() / l;
    visit(transform, PlainRow{stress_[h], {{from, -inverse}, {to, inverse}}, e / l});
    const Mat3 across = n * n.transpose() / lengths[h];
    visit(normal, PlainRow{kNormal * stress_[h] * l / average_, {{from, -across}, {to, across}}});
    const double shared = edges_.faceCountAt(edges_.ofHalfEdge[h]);  // an edge counts once
    visit(scale, PlainRow{kScale / average_ / shared, {{from, -I}, {to, I}}, e});
    if (problem_.sphericity[f] == 0) continue;
    const Mat3 end = I / restLengths_[last], start = cornerRotation(h) / l;
    visit(sphericity, PlainRow{problem_.sphericity[f], {{other, end}, {to, -start}, {from, start - end}}});
  }
}

/// Eq. 22.
template <typename Visit>
void PlainReshape::visitHandlesAndChains(const Scalars& lengths, Visit visit) const {
  const Handles& held = problem_.handles;
  for (std::size_t i = 0; i < held.vertices.size(); ++i)
    visit(handles, PlainRow{kHandles, {{held.vertices[i], I}}, held.targets.row(i).transpose()});
  for (const std::vector<Index>& chain : problem_.straight) {
    for (std::size_t i = 1; i + 1 < chain.size(); ++i) {
      const Mat3 before = I / lengthBetween(lengths, chain[i - 1], chain[i]);
      const Mat3 after = I / lengthBetween(lengths, chain[i], chain[i + 1]);
      visit(straight,
            PlainRow{kStraight, {{chain[i + 1], after}, {chain[i], -after - before}, {chain[i - 1], before}}});
    }
  }
}

/// Eq. 24 (as ‖e − τ ē‖²), 25, 26, 36 and 27; the term of Eq. 24 counts as `transform`.
template <typename Visit>
void PlainReshape::visitTransformationRows(Visit visit) const {
  // τ u = Σ u_j (column j of τ)
  for (Index h = 0; h < rest_.rows(); ++h) {
    const Index f = faceOf(h), last = 3 * f + oppositeCorner(h);
    const Vec3 e = rest_.row(h).transpose(), u = e / restLengths_[h];
    const Vec3 w = -rest_.row(last).transpose() / restLengths_[last], n = normals_.row(f).transpose();
    visit(transform,
          PlainRow{1 / average_, {{3 * f, e[0] * I}, {3 * f + 1, e[1] * I}, {3 * f + 2, e[2] * I}}, edgeOf(V_, h)});
    const Mat3 across = n * n.transpose();
    visit(normal, PlainRow{kNormal, {{3 * f, u[0] * across}, {3 * f + 1, u[1] * across}, {3 * f + 2, u[2] * across}}});
    visit(regularizer, PlainRow{kRegularizer, {{h, I}}, Vec3::Unit(h % 3)});
    if (problem_.sphericity[f] == 0) continue;
    const Mat3 R = cornerRotation(h);
    visit(sphericity,
          PlainRow{problem_.sphericity[f],
                   {{3 * f, w[0] * I - u[0] * R}, {3 * f + 1, w[1] * I - u[1] * R}, {3 * f + 2, w[2] * I - u[2] * R}}});
  }
  for (std::size_t i = 0; i < problem_.pairs.size(); ++i) {
    const FacePair& pair = problem_.pairs[i];
    const Index t = 3 * faceOf(pair.first), s = 3 * faceOf(pair.second);
    const auto opposite = [this](Index h) {
      return problem_.mesh.positions.row(problem_.mesh.triangles(faceOf(h), oppositeCorner(h)));
    };
    const auto visitChange = [&](Term term, double weight, const Vec3& d) {
      visit(term, PlainRow{weight,
                           {{t, d[0] * I},
                            {t + 1, d[1] * I},
                            {t + 2, d[2] * I},
                            {s, -d[0] * I},
                            {s + 1, -d[1] * I},
                            {s + 2, -d[2] * I}}});
    };
    visitChange(connect, 1, rest_.row(pair.first).transpose().normalized());
    visitChange(similarity, problem_.similarity[i],
                (opposite(pair.first) - opposite(pair.second)).transpose().normalized());
  }
}

void PlainReshape::solveVertices() {
  vertexSystem_.clear();
  const auto add = [this](Term, const PlainRow& row) { vertexSystem_.add(row, true); };
  visitVertexRows(targetLengths_, add);
  visitHandlesAndChains(targetLengths_, add);
  vertexSystem_.assemble();
  isDefinite_ = vertexSystem_.factorize() && isDefinite_;
  previous_ = V_;
  V_ = vertexSystem_.solve();
}

void PlainReshape::solveTransformations() {
  transformationSystem_.clear();
  visitTransformationRows([this](Term, const PlainRow& row) { transformationSystem_.add(row, false); });
  transformationSystem_.assemble();
  isDefinite_ = transformationSystem_.factorize() && isDefinite_;
  tau_ = transformationSystem_.solve();

  const Scalars present = presentLengths();
  stress_ = present.unaryExpr([this](double length) { return stressOf(length, average_); });
  targetLengths_.setZero();
  for (Index h = 0; h < rest_.rows(); ++h) {
    const Index edge = edges_.ofHalfEdge[h];
    const double share = (transformation(faceOf(h)) * rest_.row(h).transpose()).norm() / edges_.faceCountAt(edge);
    for (Index place = edges_.start[edge]; place < edges_.start[edge + 1]; ++place)
      targetLengths_[edges_.halfEdges[place]] += share;
  }
}

/// App. A.
bool PlainReshape::judge() {
  energies_.fill(0);
  const auto count = [this](Term term, const PlainRow& row) { energies_[term] += plainEnergy(row, V_); };
  const Scalars present = presentLengths();
  visitVertexRows(present, count);
  visitHandlesAndChains(present, count);
  visitTransformationRows([this](Term term, const PlainRow& row) {
    if (term != transform) energies_[term] += plainEnergy(row, tau_);
  });
  const double energy = std::accumulate(energies_.begin(), energies_.end(), 0.0);
  const double decrease = energyBefore_ - energy;
  energyBefore_ = energy;
  if (energy < bestEnergy_) {
    bestEnergy_ = energy;
    best_ = V_;
  }
  if (++iterations_ < 3) return iterations_ < problem_.maxIterations;
  if (decrease <= 0) {
    V_ = best_;
    return false;
  }
  const double move = (V_ - previous_).rowwise().norm().maxCoeff();
  return move >= average_ / 100 && decrease >= 0.01 / energy && iterations_ < problem_.maxIterations;
}

bool PlainReshape::iterate() {
  solveVertices();
  if (!judge()) return false;
  solveTransformations();
  return true;
}

}  // namespace whittle
