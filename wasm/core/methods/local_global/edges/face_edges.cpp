#include "methods/local_global/edges/face_edges.h"

namespace whittle {

namespace {

VectorLanes operator-(const VectorLanes& v) { return {-v.x, -v.y, -v.z}; }

}  // namespace

FaceEdges::FaceEdges(const TriangleMesh& rest, const CornerScalars& halfCotangents)
    : EdgeSet(rest.faceCount(), rest.vertexCount()), rest_(rest), halfCotangents_(halfCotangents),
      faces_(batchCount(rest.faceCount()), Faces{}) {}

void FaceEdges::collect(ElementRange range) {
  for (Index f = range.first; f < range.end; ++f) {
    Faces& faces = faces_[f / 4];
    const int lane = f % 4;
    for (int k = 0; k < 3; ++k) {
      faces.corners[k].of[lane] = rest_.triangles(f, k);
      const double c = halfCotangents_(f, k);
      if (StiffEdges::isStiff(c)) {
        addStiffEdge(rest_.triangles(f, (k + 1) % 3), rest_.triangles(f, (k + 2) % 3), c);
      } else {
        setLane(faces.weights[k], lane, static_cast<float>(c));
      }
    }
    const Mat3 g = cornerGradients(rest_, halfCotangents_, f);
    const auto edgeTo = [&](int k) {
      return rest_.positions.row(rest_.triangles(f, k)) - rest_.positions.row(rest_.triangles(f, 0));
    };
    Mat3 covariance = Mat3::Zero();
    for (int k = 1; k < 3; ++k) {
      setVector(faces.gradients[k - 1], lane, g.col(k));
      covariance += 2 * g.col(k) * edgeTo(k);
    }
    setRestCovariance(f, covariance);
  }
}

double FaceEdges::gatherCovariances(const LaneRows& displacements, ElementRange range, MatrixLanes* covariances,
                                    LaneRows& residual) const {
  DoubleLanes energies{};
  for (std::size_t b = range.firstBatch(); b < range.endBatch(); ++b, ++covariances) {
    const auto& [corners, c, g] = faces_[b];
    const VectorLanes origin = loadRows(displacements.data(), corners[0]);
    const VectorLanes toSecond = loadRows(displacements.data(), corners[1]) - origin;
    const VectorLanes toThird = loadRows(displacements.data(), corners[2]) - origin;
    const VectorLanes across = toThird - toSecond;
    const VectorLanes second = c[0] * across - c[2] * toSecond,
                      third = -(c[0] * across + c[1] * toThird);  // −L δ of the face
    energies += toDouble(c[0] * dot(across, across) + c[1] * dot(toThird, toThird) + c[2] * dot(toSecond, toSecond));
    MatrixLanes& M = *covariances = zeroMatrices();
    addOuter(M, splat(2) * g[0], toSecond);
    addOuter(M, splat(2) * g[1], toThird);
    addToRows(residual.data(), corners[0], -(second + third));
    addToRows(residual.data(), corners[1], second);
    addToRows(residual.data(), corners[2], third);
  }
  return sumOf(energies);
}

void FaceEdges::addRotationChanges(const MatrixLanes* rotationChanges, ElementRange range, LaneRows& residual) const {
  for (std::size_t b = range.firstBatch(); b < range.endBatch(); ++b, ++rotationChanges) {
    const Faces& faces = faces_[b];
    const VectorLanes second = *rotationChanges * faces.gradients[0], third = *rotationChanges * faces.gradients[1];
    addToRows(residual.data(), faces.corners[0], -(second + third));
    addToRows(residual.data(), faces.corners[1], second);
    addToRows(residual.data(), faces.corners[2], third);
  }
}

}  // namespace whittle
