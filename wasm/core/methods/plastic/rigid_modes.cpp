#include "methods/plastic/rigid_modes.h"

#include <Eigen/Cholesky>
#include <algorithm>

#include "methods/plastic/held_points.h"

namespace whittle {

namespace {

/// The member whose point is farthest by some measure.
template <typename Measure>
std::size_t farthest(std::size_t count, Measure measure) {
  std::size_t best = 0;
  for (std::size_t i = 1; i < count; ++i) {
    if (measure(i) > measure(best)) best = i;
  }
  return best;
}

}  // namespace

void RigidModes::find(const Points& positions, const Components& parts, const std::vector<Index>& nodeOf) {
  positions_ = positions;
  parts_.clear();
  count_ = 0;
  partOf_.assign(positions.rows(), -1);
  std::vector<std::vector<Index>> members(parts.count);
  for (Index v = 0; v < positions.rows(); ++v) members[parts.ofVertex[v]].push_back(v);
  for (const std::vector<Index>& vertices : members) addPart(positions, vertices, nodeOf);
}

Eigen::Matrix<double, 3, 6> RigidModes::velocity(const Part& part, const Vec3& position) {
  Eigen::Matrix<double, 3, 6> result;
  result.leftCols<3>() = -crossMatrix(position - part.center);
  result.rightCols<3>().setIdentity();
  return result;
}

void RigidModes::addPart(const Points& positions, const std::vector<Index>& vertices,
                         const std::vector<Index>& nodeOf) {
  Part part;
  std::vector<Vec3> held;
  part.center.setZero();
  for (const Index v : vertices) {
    if (nodeOf[v] < 0) {
      held.emplace_back(positions.row(v).transpose());
    } else {
      part.vertices.push_back(v);
      part.nodes.push_back(nodeOf[v]);
      part.center += positions.row(v).transpose();
    }
  }
  const HeldPoints hold(held);
  if (part.vertices.empty() || hold.rank == HeldPoints::Rank::plane) return;
  if (held.empty()) {
    part.center /= static_cast<double>(part.vertices.size());
    part.modes = Eigen::Matrix<double, 6, 6>::Identity();
  } else {
    part.center = hold.center;
    part.modes.setZero(6, hold.rank == HeldPoints::Rank::line ? 1 : 3);
    if (hold.rank == HeldPoints::Rank::line) part.modes.topRows<3>() = hold.direction;
    if (hold.rank == HeldPoints::Rank::point) part.modes.topRows<3>().setIdentity();
  }
  Eigen::MatrixXd gram = Eigen::MatrixXd::Zero(part.modes.cols(), part.modes.cols());
  for (const Index v : part.vertices) {
    const Eigen::MatrixXd u = velocity(part, positions.row(v).transpose()) * part.modes;
    gram += u.transpose() * u;
  }
  const Eigen::LLT<Eigen::MatrixXd> factor(gram);
  if (factor.info() != Eigen::Success) return;
  part.modes = factor.matrixL().solve(Eigen::MatrixXd(part.modes.transpose())).transpose();
  part.first = count_;
  support(positions, held, part);
  count_ += static_cast<Index>(part.modes.cols());
  for (const Index v : vertices) partOf_[v] = static_cast<Index>(parts_.size());
  parts_.push_back(std::move(part));
}

void RigidModes::support(const Points& positions, const std::vector<Vec3>& held, Part& part) const {
  const auto at = [&](std::size_t i) -> Vec3 { return positions.row(part.vertices[i]).transpose(); };
  const std::size_t count = part.vertices.size();
  const HeldPoints hold(held);
  Vec3 first = part.center, axis = hold.direction;
  if (held.empty()) {
    const std::size_t a = farthest(count, [&](std::size_t i) { return (at(i) - part.center).squaredNorm(); });
    part.supports.emplace_back(part.nodes[a], Mat3::Identity());
    first = at(a);
  }
  if (held.empty() || hold.rank == HeldPoints::Rank::point) {
    const std::size_t b = farthest(count, [&](std::size_t i) { return (at(i) - first).squaredNorm(); });
    axis = (at(b) - first).normalized();
    part.supports.emplace_back(part.nodes[b], Mat3::Identity() - axis * axis.transpose());
  }
  const std::size_t c = farthest(count, [&](std::size_t i) { return axis.cross(at(i) - first).squaredNorm(); });
  const Vec3 normal = axis.cross(at(c) - first).normalized();
  part.supports.emplace_back(part.nodes[c], normal * normal.transpose());
}

Eigen::Matrix3Xd RigidModes::velocities(Index vertex) const {
  Eigen::Matrix3Xd result = Eigen::Matrix3Xd::Zero(3, count_);
  if (partOf_[vertex] < 0) return result;
  const Part& part = parts_[partOf_[vertex]];
  result.middleCols(part.first, part.modes.cols()) = velocity(part, positions_.row(vertex).transpose()) * part.modes;
  return result;
}

void RigidModes::takeOut(Rows& columns) const {
  for (const Part& part : parts_) {
    Rows amounts = Rows::Zero(part.modes.cols(), columns.cols());
    const auto velocityOf = [&](std::size_t i) -> Eigen::Matrix<double, 3, Eigen::Dynamic, 0, 3, 6> {
      return velocity(part, positions_.row(part.vertices[i]).transpose()) * part.modes;
    };
    for (std::size_t i = 0; i < part.nodes.size(); ++i)
      amounts.noalias() += velocityOf(i).transpose().lazyProduct(columns.middleRows(3 * part.nodes[i], 3));
    for (std::size_t i = 0; i < part.nodes.size(); ++i)
      columns.middleRows(3 * part.nodes[i], 3).noalias() -= velocityOf(i).lazyProduct(amounts);
  }
}

void RigidModes::addSupports(double spring, Stiffness& stiffness) const {
  for (const Part& part : parts_) {
    for (const auto& [node, along] : part.supports) stiffness.add(node, spring * along);
  }
}

void RigidModes::move(const Scalars& amounts, double share, Points& positions) const {
  for (const Part& part : parts_) {
    const Eigen::Matrix<double, 6, 1> screw = share * part.modes * amounts.segment(part.first, part.modes.cols());
    const Mat3 turn = rotationOf(screw.head<3>());
    for (const Index v : part.vertices) {
      const Vec3 arm = positions.row(v).transpose() - part.center;
      positions.row(v) = (part.center + turn * arm + screw.tail<3>()).transpose();
    }
  }
}

}  // namespace whittle
