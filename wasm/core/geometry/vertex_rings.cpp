#include "geometry/vertex_rings.h"

#include "mesh/adjacency.h"

namespace whittle {

namespace {

constexpr double kVisits = 3;           // elements that see each face: its corners
constexpr double kScale = 2 * kVisits;  // of ring sums that makes covariances of them

typedef double Pair __attribute__((vector_size(16)));

Pair loadPair(const double* p) {
  Pair v;
  std::memcpy(&v, p, sizeof v);
  return v;
}

/// Two numbers in single precision, made wide.
Pair loadSinglePair(const float* p) {
  typedef float Half __attribute__((vector_size(8)));
  Half v;
  std::memcpy(&v, p, sizeof v);
  return __builtin_convertvector(v, Pair);
}

}  // namespace

VertexRings::VertexRings(const TriangleMesh& rest, const CornerScalars& halfCotangents) {
  collectRings(rest, halfCotangents);
  // What makes the energy of the rest shape zero.
  std::vector<CovarianceLanes> covariances(batchCount(rest.vertexCount()));
  std::vector<LaneRow> residual(rest.vertexCount());
  restPull_ = Points::Zero(rest.vertexCount(), 3);
  const double outputEnergy = gatherCovariances(rest.positions, allElements(), covariances.data(), residual);
  for (Index k = 0; k < rest.vertexCount(); ++k) restPull_.row(k) = sumRing(rest.positions, k).pull().transpose();
  for (Index k = 0; k < rest.vertexCount(); ++k) {
    for (int i = 0; i < 3; ++i) restEnergy_ += covariances[k / 4].m[i][i][k % 4];
  }
  restEnergy_ -= outputEnergy;
}

void VertexRings::collectRings(const TriangleMesh& rest, const CornerScalars& halfCotangents) {
  const Index vertexCount = rest.vertexCount();
  const Fans fans(rest.triangles, vertexCount);
  std::vector<Mat3> gradients(rest.faceCount());
  for (Index f = 0; f < rest.faceCount(); ++f) gradients[f] = cornerGradients(rest, halfCotangents, f) / kVisits;
  std::vector<Index> place(vertexCount, -1);  // of a vertex in the lists, if it is in this ring
  std::vector<Vec3> ring;
  start_.assign(1, 0);
  spokes_.reserve(rest.triangles.size());
  weights_.reserve(rest.triangles.size());
  for (Index k = 0; k < vertexCount; ++k) {
    ring.clear();
    for (Index p = fans.start[k]; p < fans.start[k + 1]; ++p) {
      const Index f = fans.corners[p] / 3;
      const Mat3& g = gradients[f];
      const int* const others = kOtherCorners[fans.corners[p] % 3];
      for (int i = 0; i < 2; ++i) {
        const Index j = rest.triangles(f, others[i]);
        if (j == k) continue;
        if (place[j] < start_[k]) {
          place[j] = static_cast<Index>(spokes_.size());
          spokes_.push_back({0, 0, 0, j});
          weights_.push_back(0);
          ring.push_back(Vec3::Zero());
        }
        ring[place[j] - start_[k]] += g.col(others[i]);
        weights_[place[j]] += halfCotangents(f, others[1 - i]);
      }
    }
    for (std::size_t i = 0; i < ring.size(); ++i) {
      Spoke& spoke = spokes_[start_[k] + i];
      spoke.x = static_cast<float>(ring[i].x()), spoke.y = static_cast<float>(ring[i].y()), spoke.z = static_cast<float>(ring[i].z());
    }
    start_.push_back(static_cast<Index>(spokes_.size()));
  }
}

VertexRings::RingSums VertexRings::sumRing(const Points& output, Index k) const {
  const double* xk = output.data() + 3 * static_cast<std::ptrdiff_t>(k);
  const Pair kxy = loadPair(xk), kz{xk[2], xk[2]};
  Pair x{}, y{}, z{}, pull{}, xyAtZ{}, zPullAtZ{};
  for (Index p = start_[k]; p < start_[k + 1]; ++p) {
    const Spoke& spoke = spokes_[p];
    const double* xj = output.data() + 3 * static_cast<std::ptrdiff_t>(spoke.neighbour);
    const Pair uxy = loadPair(xj) - kxy, uz = Pair{xj[2], xj[2]} - kz;
    const Pair gxy = loadSinglePair(&spoke.x), gz = Pair{spoke.z, spoke.z}, w{weights_[p], weights_[p]};
    x += Pair{gxy[0], gxy[0]} * uxy;
    y += Pair{gxy[1], gxy[1]} * uxy;
    z += gz * uxy;
    pull += w * uxy;
    xyAtZ += gxy * uz;
    zPullAtZ += Pair{gz[0], w[0]} * uz;
  }
  return {{x, y, z, pull}, {xyAtZ, zPullAtZ}};
}

void VertexRings::storeCovariances(const RingSums* sums, CovarianceLanes& covariances) {
  const auto put = [&](int i, int j, Pair first, Pair second) {
    const Pair halves[] = {kScale * first, kScale * second};
    std::memcpy(&covariances.m[i][j], halves, sizeof halves);
  };
  for (int i = 0; i < 3; ++i) {
    const Pair a = sums[0].xy[i], b = sums[1].xy[i], c = sums[2].xy[i], d = sums[3].xy[i];
    put(i, 0, Pair{a[0], b[0]}, Pair{c[0], d[0]});
    put(i, 1, Pair{a[1], b[1]}, Pair{c[1], d[1]});
  }
  const auto z = [&](int lane, int i) { return sums[lane].z[i / 2][i % 2]; };
  for (int i = 0; i < 3; ++i) put(i, 2, Pair{z(0, i), z(1, i)}, Pair{z(2, i), z(3, i)});
}

double VertexRings::gatherCovariances(const Points& output, ElementRange range, CovarianceLanes* covariances,
                                      std::vector<LaneRow>& residual) const {
  double outputEnergy = 0;
  for (Index first = range.first; first < range.end; first += 4, ++covariances) {
    RingSums sums[4] = {};
    for (Index k = first; k < std::min(first + 4, range.end); ++k) {
      const RingSums& ring = sums[k - first] = sumRing(output, k);
      const Vec3 pull = ring.pull(), change = pull - restPull_.row(k).transpose();
      store(&residual[k], load(&residual[k]) + Lanes{float(change.x()), float(change.y()), float(change.z()), 0});
      outputEnergy -= output.row(k) * pull;
    }
    storeCovariances(sums, *covariances);
  }
  return kVisits * outputEnergy;
}

void VertexRings::addSimilar(const std::vector<QuaternionLanes>& rotations, const std::vector<Lanes>& growths, ElementRange range,
                             std::vector<LaneRow>& residual) const {
  for (Index k = range.first; k < range.end; k += 4) {
    const MatrixLanes R = turnAt(rotations, growths, k / 4);
    Lanes columns[3][4];
    for (int c = 0; c < 3; ++c) {
      columns[c][0] = R.m[0][c], columns[c][1] = R.m[1][c], columns[c][2] = R.m[2][c], columns[c][3] = splat(0);
      transpose(columns[c][0], columns[c][1], columns[c][2], columns[c][3]);
    }
    for (Index lane = 0; lane < std::min<Index>(4, range.end - k); ++lane) {
      const Lanes x = columns[0][lane], y = columns[1][lane], z = columns[2][lane];
      Lanes own = splat(0);
      for (Index p = start_[k + lane]; p < start_[k + lane + 1]; ++p) {
        const Spoke& spoke = spokes_[p];
        const Lanes rotated = loadSplat(&spoke.x) * x + loadSplat(&spoke.y) * y + loadSplat(&spoke.z) * z;
        LaneRow* row = &residual[spoke.neighbour];
        store(row, load(row) + rotated);
        own += rotated;
      }
      LaneRow* row = &residual[k + lane];
      store(row, load(row) - own);
    }
  }
}

}  // namespace whittle
