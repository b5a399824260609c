#include "constraints/attachments.h"

#include "mesh/disjoint_sets.h"

namespace whittle {

SparseMatrix Attachments::lower(Index vertexCount, const std::vector<Index>& held) const {
  std::vector<bool> isHeld(vertexCount, false);
  for (const Index v : held) isHeld[v] = true;
  std::vector<Eigen::Triplet<double, Index>> entries;
  entries.reserve(rows_.size() * Attachment::kMost * (Attachment::kMost + 1) / 2);
  for (const Attachment& row : rows_) {
    for (int i = 0; i < Attachment::kMost; ++i) {
      for (int j = 0; j < Attachment::kMost; ++j) {
        const double value = kStiffness * row.weights[i] * row.weights[j];
        if (value == 0 || isHeld[row.vertices[i]] || isHeld[row.vertices[j]]) continue;
        if (row.vertices[i] >= row.vertices[j]) entries.emplace_back(row.vertices[i], row.vertices[j], value);
      }
    }
  }
  SparseMatrix result(vertexCount, vertexCount);
  result.setFromTriplets(entries.begin(), entries.end());
  return result;
}

double Attachments::addForces(const LaneRows& displacements, LaneRows& residual) const {
  double energy = 0;
  for (const Attachment& row : rows_) {
    Lanes gap = splat(0);
    for (int i = 0; i < Attachment::kMost; ++i)
      gap += static_cast<float>(row.weights[i]) * load(&displacements[row.vertices[i]]);
    energy += kStiffness * sumOf(toDouble(gap * gap));
    for (int i = 0; i < Attachment::kMost; ++i) {
      LaneRow& r = residual[row.vertices[i]];
      store(&r, load(&r) - static_cast<float>(kStiffness * row.weights[i]) * gap);
    }
  }
  return energy;
}

double Attachments::addForces(const Points& displacements, Points& residual) const {
  double energy = 0;
  for (const Attachment& row : rows_) {
    Eigen::RowVector3d gap = Eigen::RowVector3d::Zero();
    for (int i = 0; i < Attachment::kMost; ++i) gap += row.weights[i] * displacements.row(row.vertices[i]);
    energy += kStiffness * gap.squaredNorm();
    for (int i = 0; i < Attachment::kMost; ++i) residual.row(row.vertices[i]) -= kStiffness * row.weights[i] * gap;
  }
  return energy;
}

Components Attachments::tied(const Components& parts) const {
  if (empty()) return parts;
  DisjointSets tied(parts.count);
  for (const Attachment& row : rows_) {
    for (const Index v : row.vertices) tied.join(parts.ofVertex[row.vertices[0]], parts.ofVertex[v]);
  }
  Components groups;
  std::vector<Index> groupOf(parts.count, -1);
  groups.ofVertex.reserve(parts.ofVertex.size());
  for (const Index part : parts.ofVertex) {
    Index& group = groupOf[tied.find(part)];
    if (group < 0) group = groups.count++;
    groups.ofVertex.push_back(group);
  }
  return groups;
}

}  // namespace whittle
