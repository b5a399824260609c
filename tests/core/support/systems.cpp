#include "support/systems.h"

#include <algorithm>

#include "linear/minimum_degree.h"
#include "linear/nested_dissection.h"

namespace whittle::testing {

namespace {

template <typename Task>
auto inOneGo(Task&& task) {
  while (task.next() < 1) {}
  return task.take();
}

}  // namespace

std::vector<Index> minimumDegreeOrder(const Graph& graph) { return inOneGo(MinimumDegree(graph)); }

std::vector<Index> nestedDissectionOrder(const Graph& graph, const Points& coordinates) {
  return inOneGo(NestedDissection(graph, coordinates));
}

Supernodes analyzeSupernodes(const SparseMatrix& A, const Ordering& ordering) {
  return inOneGo(SupernodeAnalysis(A, ordering));
}

Edges path(Index n) {
  Edges edges;
  for (Index i = 1; i < n; ++i) edges.emplace_back(i - 1, i);
  return edges;
}

Edges star(Index n) {
  Edges edges;
  for (Index i = 1; i < n; ++i) edges.emplace_back(0, i);
  return edges;
}

Edges complete(Index n) {
  Edges edges;
  for (Index i = 0; i < n; ++i) {
    for (Index j = 0; j < i; ++j) edges.emplace_back(i, j);
  }
  return edges;
}

Edges gridEdges(Index side) {
  Edges edges;
  for (Index r = 0; r < side; ++r) {
    for (Index c = 0; c < side; ++c) {
      if (c + 1 < side) edges.emplace_back(r * side + c, r * side + c + 1);
      if (r + 1 < side) edges.emplace_back(r * side + c, (r + 1) * side + c);
    }
  }
  return edges;
}

Edges islands(Index n) {
  Edges edges;
  for (Index i = 7; i < n; ++i) {
    if (i % 5 != 0) edges.emplace_back(i - 7, i);
  }
  return edges;
}

Edges randomTree(Index n, Noise& noise) {
  Edges edges;
  for (Index i = 1; i < n; ++i) edges.emplace_back(pick(i, noise), i);
  return edges;
}

Edges randomEdges(Index n, Index count, Noise& noise) {
  Edges edges;
  for (Index e = 0; e < count; ++e) {
    const Index i = pick(n, noise), j = pick(n, noise);
    if (i != j) edges.emplace_back(i, j);
  }
  return edges;
}

Edges edgesOf(const TriangleMesh& mesh) {
  Edges edges;
  for (Index f = 0; f < mesh.faceCount(); ++f) {
    for (int k = 0; k < 3; ++k) edges.push_back(std::minmax(mesh.triangles(f, k), mesh.triangles(f, (k + 1) % 3)));
  }
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  return edges;
}

SparseMatrix matrixOn(Index n, const Edges& edges, Noise& noise, Index blockSize) {
  std::vector<Eigen::Triplet<double, Index>> entries;
  Scalars diagonal = Scalars::Constant(n * blockSize, 0.1);
  const auto couple = [&](Index i, Index j) {
    const double value = noise();
    entries.emplace_back(i, j, value), entries.emplace_back(j, i, value);
    diagonal[i] += std::abs(value), diagonal[j] += std::abs(value);
  };
  for (const auto& [a, b] : edges) couple(a * blockSize + pick(blockSize, noise), b * blockSize + pick(blockSize, noise));
  for (Index i = 1; i < n * blockSize; ++i) {
    if (i % blockSize != 0 && i % 4 != 0) couple(i - 1, i);
  }
  for (Index i = 0; i < n * blockSize; ++i) entries.emplace_back(i, i, diagonal[i]);
  SparseMatrix A(n * blockSize, n * blockSize);
  A.setFromTriplets(entries.begin(), entries.end());
  return A;
}

Points randomPoints(Index n, Noise& noise) {
  Points points(n, 3);
  for (Index i = 0; i < n; ++i) points.row(i) << noise(), noise(), noise();
  return points;
}

Eigen::MatrixXd randomMatrix(Index rows, Index columns, Noise& noise) {
  Eigen::MatrixXd matrix(rows, columns);
  for (double& number : matrix.reshaped()) number = noise();
  return matrix;
}

Index pick(Index n, Noise& noise) { return static_cast<Index>((noise() + 1) / 2 * n) % n; }

}  // namespace whittle::testing
