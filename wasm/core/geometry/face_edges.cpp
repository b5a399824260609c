#include "geometry/face_edges.h"

namespace whittle {

namespace {

Lanes toRow(const Vec3& v) { return Lanes{static_cast<float>(v.x()), static_cast<float>(v.y()), static_cast<float>(v.z()), 0}; }

void add(LaneRow& row, Lanes v) { store(&row, load(&row) + v); }

Vec3 vectorOf(const LaneRow& row) { return {row.x, row.y, row.z}; }

}  // namespace

FaceEdges::FaceEdges(const TriangleMesh& rest, const CornerScalars& halfCotangents)
    : triangles_(rest.triangles), restPositions_(rest.positions), halfCotangents_(halfCotangents), gradients_(2 * rest.faceCount()) {
  for (Index f = 0; f < rest.faceCount(); ++f) {
    const Mat3 g = cornerGradients(rest, halfCotangents, f);
    store(&gradients_[2 * f], toRow(g.col(1)));
    store(&gradients_[2 * f + 1], toRow(g.col(2)));
  }
  // What makes the energy of the rest shape zero.
  std::vector<CovarianceLanes> covariances(batchCount(rest.faceCount()));
  std::vector<LaneRow> residual(rest.vertexCount());
  const double outputEnergy = gatherCovariances(rest.positions, allElements(), covariances.data(), residual);
  for (Index f = 0; f < rest.faceCount(); ++f) {
    for (int i = 0; i < 3; ++i) restEnergy_ += covariances[f / 4].m[i][i][f % 4];
  }
  restEnergy_ -= outputEnergy;
}

double FaceEdges::gatherCovariances(const Points& output, ElementRange range, CovarianceLanes* covariances,
                                    std::vector<LaneRow>& residual) const {
  double outputEnergy = 0;
  covariances[range.endBatch() - range.firstBatch() - 1] = {};  // what fills up the last batch
  for (Index f = range.first; f < range.end; ++f) {
    const auto corners = triangles_.row(f);
    const auto c = halfCotangents_.row(f);
    const Vec3 first = output.row(corners[0]).transpose();
    const Vec3 toSecond = output.row(corners[1]).transpose() - first, toThird = output.row(corners[2]).transpose() - first;
    const Vec3 across = toThird - toSecond;
    outputEnergy += c[0] * across.squaredNorm() + c[1] * toThird.squaredNorm() + c[2] * toSecond.squaredNorm();
    setMatrix(covariances[(f - range.first) / 4], f % 4,
              2 * (vectorOf(gradients_[2 * f]) * toSecond.transpose() + vectorOf(gradients_[2 * f + 1]) * toThird.transpose()));
    // Changes of the edges, for the residual.
    const Vec3 restFirst = restPositions_.row(corners[0]).transpose();
    const Vec3 dSecond = toSecond - (restPositions_.row(corners[1]).transpose() - restFirst);
    const Vec3 dThird = toThird - (restPositions_.row(corners[2]).transpose() - restFirst);
    const Vec3 second = c[0] * (dThird - dSecond) - c[2] * dSecond, third = c[0] * (dSecond - dThird) - c[1] * dThird;
    add(residual[corners[0]], toRow(-second - third));
    add(residual[corners[1]], toRow(second));
    add(residual[corners[2]], toRow(third));
  }
  return outputEnergy;
}

void FaceEdges::addSimilar(const std::vector<QuaternionLanes>& rotations, const std::vector<Lanes>& growths, ElementRange range,
                           std::vector<LaneRow>& residual) const {
  for (Index f = range.first; f < range.end; f += 4) {
    const MatrixLanes R = turnAt(rotations, growths, f / 4);
    for (Index lane = 0; lane < std::min<Index>(4, range.end - f); ++lane) {
      const auto column = [&](int c) { return Lanes{R.m[0][c][lane], R.m[1][c][lane], R.m[2][c][lane], 0}; };
      const Lanes x = column(0), y = column(1), z = column(2);
      const LaneRow &g1 = gradients_[2 * (f + lane)], &g2 = gradients_[2 * (f + lane) + 1];
      const Lanes second = g1.x * x + g1.y * y + g1.z * z, third = g2.x * x + g2.y * y + g2.z * z;
      const auto corners = triangles_.row(f + lane);
      add(residual[corners[0]], -(second + third));
      add(residual[corners[1]], second);
      add(residual[corners[2]], third);
    }
  }
}

}  // namespace whittle
