#pragma once

#include <vector>

#include "linear/supernodes.h"
#include "support/shapes.h"

namespace whittle::testing {

using Edges = std::vector<std::pair<Index, Index>>;

Edges path(Index n);
/// All joined to node 0: an arrow matrix.
Edges star(Index n);
Edges complete(Index n);
/// A square grid of `side`² nodes, numbered row by row.
Edges gridEdges(Index side);
/// Several islands, some of a single node, numbered criss-cross.
Edges islands(Index n);
/// A tree in which node i hangs on a random earlier one.
Edges randomTree(Index n, Noise& noise);
/// `count` random edges, some of them twice.
Edges randomEdges(Index n, Index count, Noise& noise);
Edges edgesOf(const TriangleMesh& mesh);

/// A diagonally dominant matrix with random entries on the given edges. In blocks, every edge couples some of the
/// components of its nodes, and a node some of its own.
SparseMatrix matrixOn(Index n, const Edges& edges, Noise& noise, Index blockSize = 1);

Points randomPoints(Index n, Noise& noise);

using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
Eigen::MatrixXd randomMatrix(Index rows, Index columns, Noise& noise);

/// Orders (position → node) and supernodes, each made in one go.
std::vector<Index> minimumDegreeOrder(const Graph& graph);
std::vector<Index> nestedDissectionOrder(const Graph& graph, const Points& coordinates);
Supernodes analyzeSupernodes(const SparseMatrix& A, const Ordering& ordering = {});

/// A random number of a node, in [0, n).
Index pick(Index n, Noise& noise);

}  // namespace whittle::testing
