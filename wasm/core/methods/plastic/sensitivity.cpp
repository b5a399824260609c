#include "methods/plastic/sensitivity.h"

namespace whittle {

namespace {

Vec3 dual(const Mat2& a) { return {a(0, 0), a(0, 1) + a(1, 0), a(1, 1)}; }

Mat2 symmetricPart(const Mat2& a) { return (a + a.transpose()) / 2; }

/// (g gᵀ)₁₁, (g gᵀ)₁₂, (g gᵀ)₂₂.
Vec3 squareOf(const Vec2& g) { return {g[0] * g[0], g[0] * g[1], g[1] * g[1]}; }

}  // namespace

void Sensitivity::take(const Shell& shell) {
  shell_ = &shell;
  factors_.resize(shell.faceCount());
  for (Index f = 0; f < shell.faceCount(); ++f) {
    setStretchFactors(shell, f, factors_[f]);
    setTurnFactors(shell, f, factors_[f]);
  }
}

void Sensitivity::setStretchFactors(const Shell& shell, Index face, FaceFactors& factors) const {
  const FaceGoal& goal = shell.goal(face);
  const ShellMaterial& material = shell.material();
  const FaceStress stress = shell.stress(face);
  const Mat2 &P = goal.inverse, &S = goal.stretch, &C = shell.forms(face).first;
  const Mat2 bend = shell.forms(face).second - goal.second, stretch = P * C - Mat2::Identity();
  const Mat2 inverse = S.inverse();
  const double c1 = material.onTrace(), c2 = material.onSquare();
  for (int j = 0; j < 3; ++j) {
    const Mat2& dS = stretchBasis()[j];
    const Mat2 dP = -P * (S * dS + dS * S) * P;
    const Mat2 dBend = -symmetricPart(goal.turnedEdges * dS);
    const double growth = (inverse * dS).trace();
    const Mat2 membrane = c1 * ((dP * C).trace() * P + stretch.trace() * dP) + 2 * c2 * (dP * C * P + P * C * dP - dP);
    const Mat2 moment = c1 * ((dP * bend + P * dBend).trace() * P + (P * bend).trace() * dP) +
                        2 * c2 * (dP * bend * P + P * dBend * P + P * bend * dP);
    factors.membrane.col(j) = dual(growth * stress.membrane + goal.weight * material.stretching() * membrane);
    factors.moment.col(j) = dual(growth * stress.moment + goal.weight * material.bending() * moment);
  }
}

void Sensitivity::setTurnFactors(const Shell& shell, Index face, FaceFactors& factors) const {
  const FaceGoal& goal = shell.goal(face);
  const ShellMaterial& material = shell.material();
  const Mat2& P = goal.inverse;
  const Vec3 theta = shell.plastic().rotations[face];
  const Mat3 turn = rotationOf(theta);
  factors.jacobian = leftJacobian(theta);
  for (int k = 0; k < 3; ++k) {
    factors.turned[k].setZero();
    if (shell.hinges()[face][k].face < 0) continue;
    const Shell::TurnedHinge hinge = shell.turnedHinge(face, k);
    const MidEdgeNormal middle(hinge.sum);
    for (int i = 0; i < 3; ++i) {
      // What a db of one unit, of which both off-diagonal entries are one, is worth.
      Mat2 unit = Mat2::Zero();
      unit(i / 2, (i + 1) / 2) = unit((i + 1) / 2, i / 2) = 1;
      const Mat2 worth = goal.weight * material.bending() *
                         (material.onTrace() * (P * unit).trace() * P + 2 * material.onSquare() * P * unit * P);
      const Vec2 pull = goal.stretch * worth * shell.frames()[face].gradients[k];
      const Vec3 inSpace = turn * middle.change(shell.frames()[face].axes * pull);
      factors.turned[k].col(i) = inSpace.cross(hinge.across);
    }
  }
}

void Sensitivity::apply(const Rows& changes, Rows& forces) const {
  const Index faces = shell_->faceCount(), columns = static_cast<Index>(changes.cols());
  forces.setZero(3 * shell_->vertexCount(), columns);
  const FormsInput shape = shell_->input();
  Rows stretch(3, columns), membrane(3, columns), moment(3, columns);
  for (Index f = 0; f < faces; ++f) {
    const FaceFactors& factors = factors_[f];
    stretch.row(0) = changes.row(3 * faces + f);
    stretch.bottomRows(2) = changes.middleRows(4 * faces + 2 * f, 2);
    membrane.noalias() = factors.membrane.lazyProduct(stretch);
    moment.noalias() = factors.moment.lazyProduct(stretch);
    for (int k = 0; k < 3; ++k) {
      const Index other = shell_->hinges()[f][k].face;
      if (other < 0) continue;
      const Mat3 own = -2 * factors.turned[k].transpose() * factors.jacobian;
      const Mat3 others = 2 * factors.turned[k].transpose() * factors_[other].jacobian;
      moment.noalias() += own.lazyProduct(changes.middleRows(3 * f, 3));
      moment.noalias() += others.lazyProduct(changes.middleRows(3 * other, 3));
    }
    const auto at = [&](Index vertex) { return forces.middleRows(3 * vertex, 3); };
    for (int k = 0; k < 3; ++k) {
      const Vec2& g = shell_->frames()[f].gradients[k];
      const Mat3 byCorner = firstFormGradient(shell_->forms(f), g).transpose();
      at(shell_->triangles()(f, k)).noalias() += byCorner.lazyProduct(membrane);
      const FaceHinge& hinge = shell_->hinges()[f][k];
      if (hinge.face < 0) continue;
      const RiseGradient rise = riseGradient(shape, shell_->forms(f), f, k);
      const Eigen::RowVector3d square = -squareOf(g).transpose();
      for (int a = 0; a < 3; ++a)
        at(shell_->triangles()(f, a)).noalias() += (rise.corners[a] * square).lazyProduct(moment);
      const Index across = shell_->triangles()(hinge.face, hinge.opposite);
      at(across).noalias() += (rise.across * square).lazyProduct(moment);
    }
  }
}

void Sensitivity::applyTransposed(const Rows& Y, Rows& result) const {
  const Index faces = shell_->faceCount(), columns = static_cast<Index>(Y.cols());
  result.setZero(6 * faces, columns);
  const FormsInput shape = shell_->input();
  Rows first(3, columns), second(3, columns), turn(3, columns);  // dC, db, what θ gets
  for (Index f = 0; f < faces; ++f) {
    const FaceFactors& factors = factors_[f];
    first.setZero();
    second.setZero();
    const auto at = [&](Index vertex) { return Y.middleRows(3 * vertex, 3); };
    for (int k = 0; k < 3; ++k) {
      const Vec2& g = shell_->frames()[f].gradients[k];
      const Mat3 byCorner = firstFormGradient(shell_->forms(f), g);
      first.noalias() += byCorner.lazyProduct(at(shell_->triangles()(f, k)));
      const FaceHinge& hinge = shell_->hinges()[f][k];
      if (hinge.face < 0) continue;
      const RiseGradient rise = riseGradient(shape, shell_->forms(f), f, k);
      const Vec3 square = squareOf(g);
      for (int a = 0; a < 3; ++a) {
        second.noalias() -= (square * rise.corners[a].transpose()).lazyProduct(at(shell_->triangles()(f, a)));
      }
      const Index across = shell_->triangles()(hinge.face, hinge.opposite);
      second.noalias() -= (square * rise.across.transpose()).lazyProduct(at(across));
    }
    const Mat3 membrane = factors.membrane.transpose(), moment = factors.moment.transpose();
    turn.noalias() = membrane.lazyProduct(first);
    turn.noalias() += moment.lazyProduct(second);
    result.row(3 * faces + f) = turn.row(0);
    result.middleRows(4 * faces + 2 * f, 2) = turn.middleRows(1, 2);
    for (int k = 0; k < 3; ++k) {
      const Index other = shell_->hinges()[f][k].face;
      if (other < 0) continue;
      const Mat3 own = -2 * factors.jacobian.transpose() * factors.turned[k];
      const Mat3 others = 2 * factors_[other].jacobian.transpose() * factors.turned[k];
      result.middleRows(3 * f, 3).noalias() += own.lazyProduct(second);
      result.middleRows(3 * other, 3).noalias() += others.lazyProduct(second);
    }
  }
}

}  // namespace whittle
