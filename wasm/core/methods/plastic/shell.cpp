#include "methods/plastic/shell.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace whittle {

namespace {

/// The smaller eigenvalue of a symmetric matrix.
double smallerEigenvalue(const Mat2& a) {
  const double mean = (a(0, 0) + a(1, 1)) / 2, difference = (a(0, 0) - a(1, 1)) / 2;
  return mean - std::hypot(difference, a(0, 1));
}

}  // namespace

void Shell::setRest(TriangleMesh rest, const ShellMaterial& material) {
  rest_ = std::move(rest);
  material_ = material;
  hinges_ = faceHinges(rest_.triangles, MeshEdges(rest_.triangles, rest_.vertexCount()));
  const Points positions = rest_.positions;
  setRestPositions(positions);
}

void Shell::setRestPositions(const Points& positions) {
  rest_.positions = positions;
  frames_.resize(faceCount());
  for (Index f = 0; f < faceCount(); ++f) {
    const auto corner = [&](int k) -> Vec3 { return positions.row(rest_.triangles(f, k)).transpose(); };
    frames_[f] = FaceFrame::of({corner(0), corner(1), corner(2)});
  }
  setPlastic(PlasticField::identity(faceCount()));
  setShape(positions);
}

void Shell::setPlastic(const PlasticField& field) {
  plastic_ = field;
  turns_.resize(faceCount());
  for (Index f = 0; f < faceCount(); ++f) turns_[f] = rotationOf(plastic_.rotations[f]);
  setGoals();
}

Shell::TurnedHinge Shell::turnedHinge(Index face, int k) const {
  const FaceHinge& hinge = hinges_[face][k];
  const Vec3 across = turns_[hinge.face] * (hinge.sign * frames_[hinge.face].normal);
  return {frames_[face].normal + turns_[face].transpose() * across, across};
}

void Shell::setGoals() {
  goals_.resize(faceCount());
  for (Index f = 0; f < faceCount(); ++f) {
    FaceGoal& goal = goals_[f];
    goal.stretch = plastic_.stretches[f];
    goal.inverse = (goal.stretch * goal.stretch).inverse();
    goal.weight = frames_[f].area * goal.stretch.determinant();
    goal.turnedEdges.setZero();
    for (int k = 0; k < 3; ++k) {
      if (hinges_[f][k].face < 0) continue;
      const Vec2 tangent = frames_[f].axes.transpose() * MidEdgeNormal(turnedHinge(f, k).sum).normal;
      goal.turnedEdges += 2 * frames_[f].gradients[k] * tangent.transpose();
    }
    const Mat2 second = goal.turnedEdges * goal.stretch;
    goal.second = (second + second.transpose()) / 2;
  }
}

void Shell::setShape(const Points& positions) {
  positions_ = positions;
  findTilts(positions_, rest_.triangles, tilts_);
  forms_.resize(faceCount());
  for (Index f = 0; f < faceCount(); ++f) forms_[f] = formsOf(input(), frames_[f], f);
}

FaceStress Shell::stress(Index face) const {
  const FaceGoal& goal = goals_[face];
  const double onTrace = material_.onTrace(), onSquare = material_.onSquare();
  const Mat2& P = goal.inverse;
  const Mat2 stretch = P * forms_[face].first - Mat2::Identity();
  const Mat2 bend = P * (forms_[face].second - goal.second);
  const auto density = [&](const Mat2& M) { return onTrace / 2 * M.trace() * M.trace() + onSquare * (M * M).trace(); };
  const auto derivative = [&](const Mat2& M) -> Mat2 { return onTrace * M.trace() * P + 2 * onSquare * M * P; };
  const double stretching = goal.weight * material_.stretching(), bending = goal.weight * material_.bending();
  return {stretching * density(stretch) + bending * density(bend), stretching * derivative(stretch),
          bending * derivative(bend)};
}

double Shell::energy() const {
  double energy = 0;
  for (Index f = 0; f < faceCount(); ++f) energy += stress(f).energy;
  return energy;
}

double Shell::energy(Points& gradient) const {
  gradient.setZero();
  double energy = 0;
  for (Index f = 0; f < faceCount(); ++f) {
    const FaceStress stress = this->stress(f);
    energy += stress.energy;
    addForces(f, stress.membrane, stress.moment, gradient);
  }
  return energy;
}

void Shell::addForces(Index face, const Mat2& membrane, const Mat2& moment, Points& forces) const {
  const FormsInput shape = input();
  const Mat32 pull = 2 * forms_[face].gradient * membrane;
  for (int k = 0; k < 3; ++k) {
    const Vec2& g = frames_[face].gradients[k];
    forces.row(rest_.triangles(face, k)) += (pull * g).transpose();
    const FaceHinge& hinge = hinges_[face][k];
    if (hinge.face < 0) continue;
    const double byHeight = -g.dot(moment * g);
    const RiseGradient rise = riseGradient(shape, forms_[face], face, k);
    for (int a = 0; a < 3; ++a) forces.row(rest_.triangles(face, a)) += byHeight * rise.corners[a].transpose();
    forces.row(rest_.triangles(hinge.face, hinge.opposite)) += byHeight * rise.across.transpose();
  }
}

double Shell::smallestSquaredStretch() const {
  double smallest = std::numeric_limits<double>::infinity();
  for (Index f = 0; f < faceCount(); ++f) {
    const Mat2 inverse = goals_[f].stretch.inverse();
    smallest = std::min(smallest, smallerEigenvalue(inverse * forms_[f].first * inverse));
  }
  return smallest;
}

}  // namespace whittle
