#include "geometry/fundamental_forms.h"

namespace whittle {

namespace {

/// Mid-edge normals of pairs of faces whose normals add up to less are those of a fold.
constexpr double kFolded = 0.05;

Rise riseOf(const FormsInput& mesh, Index face, int k) {
  const FaceHinge& hinge = mesh.hinges[face][k];
  if (hinge.face < 0) return {};
  const MidEdgeNormal middle(mesh.tilts[face].normal + hinge.sign * mesh.tilts[hinge.face].normal);
  const Vec3 across = mesh.corner(face, (k + 1) % 3) + mesh.corner(face, (k + 2) % 3) - 2 * mesh.corner(face, k);
  return {across.dot(middle.normal), middle.normal, middle.change(across)};
}

}  // namespace

std::vector<FaceHinges> faceHinges(const Triangles& triangles, const MeshEdges& edges) {
  std::vector<FaceHinges> hinges(triangles.rows());
  for (Index h = 0; h < static_cast<Index>(triangles.size()); ++h) {
    const Index edge = edges.ofHalfEdge[h];
    if (edge < 0 || edges.faceCountAt(edge) < 2) continue;
    Index place = edges.start[edge];
    while (edges.halfEdges[place] != h) ++place;
    const Index next = place + 1 < edges.start[edge + 1] ? place + 1 : edges.start[edge];
    const Index other = edges.halfEdges[next];
    if (faceOf(other) == faceOf(h)) continue;
    FaceHinge& hinge = hinges[faceOf(h)][oppositeCorner(h)];
    hinge.face = faceOf(other);
    hinge.opposite = oppositeCorner(other);
    // A neighbour that looks the same way runs along the side the other way round.
    const bool runsBack = triangles(faceOf(h), tailCorner(h)) == triangles(faceOf(other), headCorner(other));
    hinge.sign = runsBack ? 1 : -1;
    hinge.onSide = {runsBack ? headCorner(other) : tailCorner(other), runsBack ? tailCorner(other) : headCorner(other)};
  }
  return hinges;
}

FaceFrame FaceFrame::of(const std::array<Vec3, 3>& corners) {
  const Vec3 first = corners[1] - corners[0], second = corners[2] - corners[0];
  const double length = first.norm();
  FaceFrame frame;
  frame.normal = first.cross(second).normalized();
  frame.axes.col(0) = first / length;
  frame.axes.col(1) = frame.normal.cross(frame.axes.col(0));
  // In the frame the corners are at (0, 0), (length, 0) and (along, height).
  const double along = second.dot(frame.axes.col(0)), height = second.dot(frame.axes.col(1));
  frame.gradients[1] = {1 / length, -along / (length * height)};
  frame.gradients[2] = {0, 1 / height};
  frame.gradients[0] = -frame.gradients[1] - frame.gradients[2];
  frame.area = length * height / 2;
  return frame;
}

void findTilts(const Points& positions, const Triangles& triangles, std::vector<FaceTilt>& tilts) {
  tilts.resize(triangles.rows());
  for (Index f = 0; f < triangles.rows(); ++f) {
    const Vec3 a = positions.row(triangles(f, 0)), b = positions.row(triangles(f, 1)),
               c = positions.row(triangles(f, 2));
    const Vec3 cross = (b - a).cross(c - a);
    const double twiceArea = cross.norm();
    const Vec3 normal = cross / twiceArea, scaled = normal / twiceArea;
    tilts[f] = {normal, {scaled.cross(c - b), scaled.cross(a - c), scaled.cross(b - a)}};
  }
}

MidEdgeNormal::MidEdgeNormal(const Vec3& sum) : length(sum.norm()), isUnit(length >= kFolded) {
  if (!isUnit) length = kFolded;
  normal = sum / length;
}

FaceForms formsOf(const FormsInput& mesh, const FaceFrame& rest, Index face) {
  FaceForms forms;
  forms.gradient.setZero();
  forms.second.setZero();
  for (int k = 0; k < 3; ++k) {
    const Vec2& g = rest.gradients[k];
    forms.gradient += mesh.corner(face, k) * g.transpose();
    forms.rises[k] = riseOf(mesh, face, k);
    forms.second -= forms.rises[k].height * g * g.transpose();
  }
  forms.first = forms.gradient.transpose() * forms.gradient;
  return forms;
}

Mat3 firstFormGradient(const FaceForms& forms, const Vec2& g) {
  Mat3 rows;
  rows.row(0) = 2 * g[0] * forms.gradient.col(0).transpose();
  rows.row(1) = g[1] * forms.gradient.col(0).transpose() + g[0] * forms.gradient.col(1).transpose();
  rows.row(2) = 2 * g[1] * forms.gradient.col(1).transpose();
  return rows;
}

RiseGradient riseGradient(const FormsInput& mesh, const FaceForms& forms, Index face, int k) {
  const FaceHinge& hinge = mesh.hinges[face][k];
  const Rise& rise = forms.rises[k];
  const FaceTilt &own = mesh.tilts[face], &other = mesh.tilts[hinge.face];
  const Vec3 otherNormal = hinge.sign * other.normal;
  RiseGradient result;
  for (int a = 0; a < 3; ++a)
    result.corners[a] = (a == k ? -2 : 1) * rise.normal - rise.turn.dot(own.slopes[a]) * own.normal;
  for (int side = 0; side < 2; ++side)
    result.corners[(k + 1 + side) % 3] -= rise.turn.dot(other.slopes[hinge.onSide[side]]) * otherNormal;
  result.across = -rise.turn.dot(other.slopes[hinge.opposite]) * otherNormal;
  return result;
}

}  // namespace whittle
