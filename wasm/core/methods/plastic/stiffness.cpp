#include "methods/plastic/stiffness.h"

#include <cmath>

namespace whittle {

namespace {

/// The second derivative of a face's energy, a 3×3 block for each pair of its six vertices (a, c ≤ a).
class FaceStiffness {
 public:
  FaceStiffness(const Shell& shell, Index face) : shell_(shell), face_(face) {
    for (Mat3& block : blocks_) block.setZero();
    addMembrane();
    addBending();
  }

  const Mat3& block(int pair) const { return blocks_[pair]; }

 private:
  static int pairOf(int a, int c) { return a * (a + 1) / 2 + c; }

  Mat3 formGradient(int corner) const {
    return firstFormGradient(shell_.forms(face_), shell_.frames()[face_].gradients[corner]);
  }

  void addMembrane() {
    const FaceGoal& goal = shell_.goal(face_);
    const ShellMaterial& material = shell_.material();
    const Mat2& P = goal.inverse;
    const Vec3 traces(P(0, 0), 2 * P(0, 1), P(1, 1));
    // tr(P Eᵢ P Eⱼ) for E = {11, 12 + 21, 22}.
    Mat3 squares;
    squares << P(0, 0) * P(0, 0), 2 * P(0, 0) * P(0, 1), P(0, 1) * P(0, 1),  //
        2 * P(0, 0) * P(0, 1), 2 * (P(0, 0) * P(1, 1) + P(0, 1) * P(0, 1)), 2 * P(0, 1) * P(1, 1), P(0, 1) * P(0, 1),
        2 * P(0, 1) * P(1, 1), P(1, 1) * P(1, 1);
    const Mat3 H = goal.weight * material.stretching() *
                   (material.onTrace() * traces * traces.transpose() + 2 * material.onSquare() * squares);
    const Mat2 sigma = positivePart(shell_.stress(face_).membrane);
    const std::array<Mat3, 3> J = {formGradient(0), formGradient(1), formGradient(2)};
    for (int c = 0; c < 3; ++c) {
      const Mat3 HJ = H * J[c];
      const Vec2 pulled = 2 * sigma * shell_.frames()[face_].gradients[c];
      for (int a = c; a < 3; ++a) {
        Mat3& block = blocks_[pairOf(a, c)];
        block += J[a].transpose() * HJ;
        block.diagonal().array() += shell_.frames()[face_].gradients[a].dot(pulled);
      }
    }
  }

  void addBending() {
    const FaceGoal& goal = shell_.goal(face_);
    const ShellMaterial& material = shell_.material();
    const FaceHinges& hinges = shell_.hinges()[face_];
    std::array<std::array<Vec3, 6>, 3> J;  // of each rise with respect to the six vertices
    for (int k = 0; k < 3; ++k) {
      J[k].fill(Vec3::Zero());
      if (hinges[k].face < 0) continue;
      const RiseGradient rise = riseGradient(shell_.input(), shell_.forms(face_), face_, k);
      for (int a = 0; a < 3; ++a) J[k][a] = rise.corners[a];
      J[k][3 + k] = rise.across;
    }
    Mat3 H;
    const auto& g = shell_.frames()[face_].gradients;
    for (int k = 0; k < 3; ++k) {
      for (int l = 0; l < 3; ++l) {
        const double own = g[k].dot(goal.inverse * g[k]), other = g[l].dot(goal.inverse * g[l]);
        const double both = g[k].dot(goal.inverse * g[l]);
        H(k, l) = goal.weight * material.bending() *
                  (material.onTrace() * own * other + 2 * material.onSquare() * both * both);
      }
    }
    for (int c = 0; c < 6; ++c) {
      for (int k = 0; k < 3; ++k) {
        const Vec3 HJ = H(k, 0) * J[0][c] + H(k, 1) * J[1][c] + H(k, 2) * J[2][c];
        // Of the vertices across sides only side k's is in rise k.
        for (int a = c; a < 3; ++a) blocks_[pairOf(a, c)] += J[k][a] * HJ.transpose();
        if (3 + k >= c) blocks_[pairOf(3 + k, c)] += J[k][3 + k] * HJ.transpose();
      }
    }
  }

  const Shell& shell_;
  Index face_;
  std::array<Mat3, 21> blocks_;
};

}  // namespace

Mat2 positivePart(const Mat2& a) {
  const double mean = (a(0, 0) + a(1, 1)) / 2, radius = std::hypot((a(0, 0) - a(1, 1)) / 2, a(0, 1));
  const double larger = mean + radius, smaller = mean - radius;
  if (smaller >= 0) return a;
  if (larger <= 0) return Mat2::Zero();
  return larger * (a - smaller * Mat2::Identity()) / (larger - smaller);
}

Stiffness::Stiffness(const Shell& shell, std::vector<Index> nodeOf) : nodeOf_(std::move(nodeOf)) {
  Index nodes = 0;
  for (const Index node : nodeOf_) nodes += node >= 0;
  std::vector<std::array<Index, 2>> pairs;
  stencils_.resize(shell.faceCount());
  for (Index f = 0; f < shell.faceCount(); ++f) {
    std::array<Index, 6>& stencil = stencils_[f].nodes;
    for (int k = 0; k < 3; ++k) {
      const FaceHinge& hinge = shell.hinges()[f][k];
      stencil[k] = nodeOf_[shell.triangles()(f, k)];
      stencil[3 + k] = hinge.face < 0 ? -1 : nodeOf_[shell.triangles()(hinge.face, hinge.opposite)];
    }
    for (int a = 0; a < 6; ++a) {
      for (int c = 0; c < a; ++c) {
        if (stencil[a] >= 0 && stencil[c] >= 0) pairs.push_back({stencil[a], stencil[c]});
      }
    }
  }
  blocks_ = SymmetricBlocks(nodes, std::move(pairs));
  for (Stencil& stencil : stencils_) {
    int pair = 0;
    for (int a = 0; a < 6; ++a) {
      for (int c = 0; c <= a; ++c, ++pair) {
        const Index row = stencil.nodes[a], column = stencil.nodes[c];
        stencil.places[pair] = row < 0 || column < 0 ? -1 : blocks_.place(row, column);
      }
    }
  }
}

void Stiffness::assemble(const Shell& shell) {
  blocks_.setZero();
  for (Index f = 0; f < shell.faceCount(); ++f) {
    const FaceStiffness stiffness(shell, f);
    const Stencil& stencil = stencils_[f];
    int pair = 0;
    for (int a = 0; a < 6; ++a) {
      for (int c = 0; c <= a; ++c, ++pair) {
        if (stencil.places[pair] < 0) continue;
        const Mat3& block = stiffness.block(pair);
        // The same vertex twice, across two sides of a face: both orders of the pair are on the diagonal.
        if (a != c && stencil.nodes[a] == stencil.nodes[c]) {
          blocks_.add(stencil.places[pair], block + block.transpose());
        } else {
          blocks_.add(stencil.places[pair], stencil.nodes[a] >= stencil.nodes[c] ? block : Mat3(block.transpose()));
        }
      }
    }
  }
}

}  // namespace whittle
