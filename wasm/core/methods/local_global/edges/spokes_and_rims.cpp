#include "methods/local_global/edges/spokes_and_rims.h"

#include <algorithm>

#include "mesh/adjacency.h"

namespace whittle {

namespace {

constexpr double kVisits = 3;          // elements that see each face
constexpr float kScale = 2 * kVisits;  // of ring sums that makes covariances of them

/// A neighbour in the ring of a vertex, before it is rounded.
struct WideSpoke {
  Vec3 gradient;
  double weight;
  Index neighbour;
};

}  // namespace

/// Collects the rings of vertices, one after the other.
class SpokesAndRims::RingCollector {
 public:
  RingCollector(const TriangleMesh& rest, const CornerScalars& halfCotangents)
      : rest_(rest), halfCotangents_(halfCotangents), fans_(rest.triangles, rest.vertexCount()),
        place_(rest.vertexCount(), -1) {
    gradients_.reserve(rest.faceCount());
    for (Index f = 0; f < rest.faceCount(); ++f)
      gradients_.push_back(cornerGradients(rest, halfCotangents, f) / kVisits);
  }

  /// Into an empty list.
  void collect(Index k, std::vector<WideSpoke>& ring) {
    for (Index p = fans_.start[k]; p < fans_.start[k + 1]; ++p) addFace(k, fans_.corners[p], ring);
    for (const WideSpoke& spoke : ring) place_[spoke.neighbour] = -1;
  }

  /// M⁰_k
  Mat3 covariance(Index k, const std::vector<WideSpoke>& ring) const {
    Mat3 sum = Mat3::Zero();
    for (const WideSpoke& spoke : ring)
      sum += spoke.gradient * (rest_.positions.row(spoke.neighbour) - rest_.positions.row(k));
    return kScale * sum;
  }

 private:
  /// What the face of a corner of k says of its other two.
  void addFace(Index k, Index corner, std::vector<WideSpoke>& ring) {
    const Index f = corner / 3;
    const int* const others = kOtherCorners[corner % 3];
    for (int i = 0; i < 2; ++i) {
      const Index j = rest_.triangles(f, others[i]);
      if (j == k) continue;
      if (place_[j] < 0) {
        place_[j] = static_cast<Index>(ring.size());
        ring.push_back({Vec3::Zero(), 0, j});
      }
      ring[place_[j]].gradient += gradients_[f].col(others[i]);
      ring[place_[j]].weight += halfCotangents_(f, others[1 - i]);
    }
  }

  const TriangleMesh& rest_;
  const CornerScalars& halfCotangents_;
  Fans fans_;
  std::vector<Mat3> gradients_;
  std::vector<Index> place_;  // of a vertex in the present ring, or −1
};

SpokesAndRims::SpokesAndRims(const TriangleMesh& rest, const CornerScalars& halfCotangents)
    : EdgeSet(rest.vertexCount(), rest.vertexCount()),
      collector_(std::make_unique<RingCollector>(rest, halfCotangents)), start_(1, 0) {
  spokes_.reserve(rest.triangles.size() / 2);
}

SpokesAndRims::~SpokesAndRims() = default;

void SpokesAndRims::endCollecting() { collector_.reset(); }

void SpokesAndRims::collect(ElementRange range) {
  std::vector<WideSpoke> rings[4];
  for (Index first = range.first; first < range.end; first += 4) {
    std::size_t longest = 0;
    for (Index lane = 0; lane < 4; ++lane) {
      const Index k = first + lane;
      rings[lane].clear();
      if (k >= range.end) continue;
      collector_->collect(k, rings[lane]);
      setRestCovariance(k, collector_->covariance(k, rings[lane]));
      longest = std::max(longest, rings[lane].size());
    }
    for (std::size_t slot = 0; slot < longest; ++slot) {
      Spokes& spokes = spokes_.emplace_back(Spokes{{splat(0), splat(0), splat(0)}, splat(0), {}});
      for (Index lane = 0; lane < 4; ++lane) {
        spokes.neighbours.of[lane] = first + lane;
        if (slot >= rings[lane].size()) continue;
        const WideSpoke& spoke = rings[lane][slot];
        setVector(spokes.gradients, lane, spoke.gradient);
        spokes.neighbours.of[lane] = spoke.neighbour;
        if (!StiffEdges::isStiff(spoke.weight)) {
          setLane(spokes.weights, lane, static_cast<float>(spoke.weight));
        } else if (first + lane < spoke.neighbour) {
          addStiffEdge(first + lane, spoke.neighbour, spoke.weight);
        }
      }
    }
    start_.push_back(static_cast<Index>(spokes_.size()));
  }
}

double SpokesAndRims::gatherCovariances(const LaneRows& displacements, ElementRange range, MatrixLanes* covariances,
                                        LaneRows& residual) const {
  const LaneRow* rows = displacements.data();
  DoubleLanes energies{};
  for (std::size_t b = range.firstBatch(); b < range.endBatch(); ++b, ++covariances) {
    const VectorLanes own = loadRows(rows + 4 * b);
    MatrixLanes M = zeroMatrices();
    VectorLanes forces{splat(0), splat(0), splat(0)};  // −L δ
    Lanes energy = splat(0);
    for (Index p = start_[b]; p < start_[b + 1]; ++p) {
      const Spokes& spokes = spokes_[p];
      const VectorLanes u = loadRows(rows, spokes.neighbours) - own;
      addOuter(M, spokes.gradients, u);
      const VectorLanes force = spokes.weights * u;
      forces = forces + force;
      energy += dot(force, u);
    }
    for (auto& row : M.m) {
      for (Lanes& entry : row) entry *= kScale;
    }
    *covariances = M;
    addToRows(&residual[4 * b], forces);
    energies += toDouble(energy);
  }
  return kVisits / 2 * sumOf(energies);  // each edge is seen from both of its ends
}

void SpokesAndRims::addRotationChanges(const MatrixLanes* rotationChanges, ElementRange range,
                                       LaneRows& residual) const {
  LaneRow* rows = residual.data();
  for (std::size_t b = range.firstBatch(); b < range.endBatch(); ++b, ++rotationChanges) {
    const MatrixLanes T = *rotationChanges;
    VectorLanes own{splat(0), splat(0), splat(0)};
    for (Index p = start_[b]; p < start_[b + 1]; ++p) {
      const VectorLanes change = T * spokes_[p].gradients;
      addToRows(rows, spokes_[p].neighbours, change);
      own = own - change;
    }
    addToRows(rows + 4 * b, own);
  }
}

}  // namespace whittle
