#include "methods/plastic/plastic_prior.h"

#include <algorithm>
#include <cmath>

#include "mesh/adjacency.h"
#include "mesh/disjoint_sets.h"

namespace whittle {

namespace {

/// How far a weight may be from that of an equilateral face among its like.
constexpr double kMostWeight = 20;
/// Without β, a field of stretches along directions that are parallel all over, as flat sheets have, costs this share of α.
constexpr double kParallelCost = 1e-7;
/// Columns that are solved in a slice: fewer where each is long.
Index batchWidth(Index rows) {
  constexpr Index kNumbers = 240000, kGroup = 3;
  return std::clamp<Index>(kNumbers / rows / kGroup * kGroup, kGroup, ConjugateGradients::kBatch);
}
/// What is left of a residual, and iterations for it. For a search direction a step or two are enough, but not none: what the
/// factor's single precision leaves on large meshes is too much for conjugate gradients around it.
constexpr ConjugateGradients::Limits kSolve{1e-6, 8}, kRoughSolve{1e-4, 3};

double clamped(double weight) { return std::clamp(weight, 1 / kMostWeight, kMostWeight); }

/// The side of a face that is opposite to corner k, in the face's frame.
Vec2 sideInFrame(const FormsInput& mesh, const FaceFrame& frame, Index face, int k) {
  return frame.axes.transpose() * (mesh.corner(face, (k + 2) % 3) - mesh.corner(face, (k + 1) % 3));
}

/// Takes (S₁₁ − S₂₂, 2 S₁₂) from the frame of the face across side k into that of the face.
Mat2 unfolding(const Shell& shell, Index face, int k) {
  const FaceHinge& hinge = shell.hinges()[face][k];
  const Vec2 own = sideInFrame(shell.input(), shell.frames()[face], face, k);
  // The neighbour sees the edge from the same end, from the corner that is in k + 1 to that in k + 2.
  const Vec2 other = shell.frames()[hinge.face].axes.transpose() * (shell.input().corner(hinge.face, hinge.onSide[1]) -
                                                                    shell.input().corner(hinge.face, hinge.onSide[0]));
  const double ownAngle = std::atan2(own.y(), own.x()), otherAngle = std::atan2(other.y(), other.x());
  // Where the two look different ways, what is unfolded is also mirrored.
  const double angle = 2 * (ownAngle - hinge.sign * otherAngle);
  const double c = std::cos(angle), s = std::sin(angle);
  Mat2 result;
  result << c, -hinge.sign * s, s, hinge.sign * c;
  return result;
}

}  // namespace

double meanSide(const Shell& shell) {
  double sum = 0;
  for (Index f = 0; f < shell.faceCount(); ++f) {
    for (int k = 0; k < 3; ++k) sum += sideInFrame(shell.input(), shell.frames()[f], f, k).norm();
  }
  return sum / (3 * shell.faceCount());
}

void PlasticPrior::shape(const Shell& shell, double alpha, double beta) {
  faces_ = shell.faceCount();
  alpha_ = alpha;
  weigh(shell);
  assemble(shell, beta);
  growth_.resize(6 * faces_, 0);
  grounds_.clear();
  if (beta == 0) ground(shell);
  centers_.resize(faces_, 3);
  for (Index f = 0; f < faces_; ++f) {
    const FormsInput mesh = shell.input();
    centers_.row(f) = (mesh.corner(f, 0) + mesh.corner(f, 1) + mesh.corner(f, 2)).transpose() / 3;
  }
  scalarFactor_.beginAnalyze(scalar_, {.coordinates = &centers_});
  deviatorFactor_.beginAnalyze(deviator_, {.coordinates = &centers_, .blockSize = 2});
  stage_ = 0;
}

/// Areas and lengths of the rest shape as weights.
void PlasticPrior::weigh(const Shell& shell) {
  double meanArea = 0;
  for (const FaceFrame& frame : shell.frames()) meanArea += frame.area / faces_;
  masses_.resize(faces_);
  couplings_.assign(faces_, {0, 0, 0});
  const auto height = [&](Index face, double side) { return 2 * shell.frames()[face].area / side / 3; };
  for (Index f = 0; f < faces_; ++f) {
    masses_[f] = clamped(shell.frames()[f].area / meanArea);
    for (int k = 0; k < 3; ++k) {
      const Index other = shell.hinges()[f][k].face;
      if (other < 0) continue;
      const double side = sideInFrame(shell.input(), shell.frames()[f], f, k).norm();
      couplings_[f][k] = clamped(side / (height(f, side) + height(other, side)) / std::sqrt(3.0));
    }
  }
}

void PlasticPrior::assemble(const Shell& shell, double beta) {
  std::vector<Eigen::Triplet<double, Index>> scalars, deviators;
  const auto addBlock = [&](Index f, Index g, const Mat2& block) {
    for (int row = 0; row < 2; ++row) {
      for (int column = 0; column < 2; ++column)
        deviators.emplace_back(2 * f + row, 2 * g + column, block(row, column));
    }
  };
  for (Index f = 0; f < faces_; ++f) {
    const double scale = 1 / std::sqrt(masses_[f]);
    double sum = 0;
    for (int k = 0; k < 3; ++k) {
      const Index other = shell.hinges()[f][k].face;
      if (other < 0) continue;
      const double weight = scale * couplings_[f][k];
      sum += weight;
      scalars.emplace_back(f, other, weight);
      addBlock(f, other, weight * unfolding(shell, f, k));
    }
    scalars.emplace_back(f, f, -sum);
    addBlock(f, f, -sum * Mat2::Identity());
  }
  const auto form = [&](Index size, const std::vector<Eigen::Triplet<double, Index>>& entries, double mass) {
    SparseMatrix L(size, size);
    L.setFromTriplets(entries.begin(), entries.end());
    SparseMatrix A = alpha_ * SparseMatrix(L.transpose() * L);
    for (Index i = 0; i < size; ++i) A.coeffRef(i, i) += mass * masses_[i * faces_ / size];
    A.makeCompressed();
    return A;
  };
  scalar_ = form(faces_, scalars, beta);
  deviator_ = form(2 * faces_, deviators, beta == 0 ? kParallelCost * alpha_ : beta);
}

/// Holds one face of each part: against loads that are in balance, the hold bears nothing.
void PlasticPrior::ground(const Shell& shell) {
  DisjointSets parts(faces_);
  for (Index f = 0; f < faces_; ++f) {
    for (const FaceHinge& hinge : shell.hinges()[f]) {
      if (hinge.face >= 0) parts.join(f, hinge.face);
    }
  }
  for (Index f = 0; f < faces_; ++f) {
    if (parts.find(f) == f) grounds_.push_back(f);
  }
  growth_.setZero(6 * faces_, static_cast<Index>(grounds_.size()));
  for (Index f = 0; f < faces_; ++f) {
    const auto root = std::lower_bound(grounds_.begin(), grounds_.end(), parts.find(f));
    const Index part = static_cast<Index>(root - grounds_.begin());
    growth_(3 * faces_ + f, part) = 1;
  }
  for (const Index root : grounds_) scalar_.coeffRef(root, root) += alpha_;
}

Status PlasticPrior::prepareNext(double& share) {
  constexpr double kStarts[] = {0, 0.25, 0.4, 0.7, 1};  // shares of the work before each stage
  double done = 1;
  Status status;
  switch (stage_) {
    case 0: done = scalarFactor_.analyzeNext(); break;
    case 1: status = scalarFactor_.factorizeNext(done); break;
    case 2: done = deviatorFactor_.analyzeNext(); break;
    case 3: status = deviatorFactor_.factorizeNext(done); break;
    default: share = 1; return {};
  }
  share = kStarts[stage_] + done * (kStarts[stage_ + 1] - kStarts[stage_]);
  if (done < 1) return status;
  ++stage_;
  if (stage_ == 1) scalarFactor_.beginFactorize(scalar_);
  if (stage_ == 3) deviatorFactor_.beginFactorize(deviator_);
  return status;
}

double PlasticPrior::energy(const Scalars& field) const {
  const Eigen::Map<const Points> rotations(field.data(), faces_, 3);
  const auto traces = field.segment(3 * faces_, faces_), deviators = field.tail(2 * faces_);
  double energy = (scalar_ * traces).dot(traces) + (deviator_ * deviators).dot(deviators);
  for (int axis = 0; axis < 3; ++axis) {
    const Scalars angles = rotations.col(axis);
    energy += (scalar_ * angles).dot(angles);
  }
  // The holds are no part of it.
  for (const Index root : grounds_) {
    energy -= alpha_ * (traces[root] * traces[root] + rotations.row(root).squaredNorm());
  }
  return energy;
}

/// Leaves of loads what is in balance over each part, and of changes what is no growth of all of it.
void PlasticPrior::takeOffGrowth(bool areLoads) {
  Rows& columns = *columns_;
  for (Index part = 0; part < growth_.cols(); ++part) {
    Eigen::RowVectorXd mean = Eigen::RowVectorXd::Zero(columns.cols());
    double mass = 0;
    for (Index f = 0; f < faces_; ++f) {
      if (growth_(3 * faces_ + f, part) == 0) continue;
      mean += (areLoads ? 1 : masses_[f]) * columns.row(3 * faces_ + f);
      mass += masses_[f];
    }
    for (Index f = 0; f < faces_; ++f) {
      if (growth_(3 * faces_ + f, part) == 0) continue;
      columns.row(3 * faces_ + f) -= (areLoads ? masses_[f] : 1) / mass * mean;
    }
  }
}

void PlasticPrior::beginSolve(Rows& columns, bool isRough) {
  columns_ = &columns;
  isRough_ = isRough;
  next_ = 0;
  takeOffGrowth(true);
}

Status PlasticPrior::solveNext(bool& isDone) {
  const Index k = static_cast<Index>(columns_->cols()), scalarColumns = 4 * k;
  const bool isScalar = next_ < scalarColumns;
  const Index rows = isScalar ? faces_ : 2 * faces_;
  const Index width = std::min<Index>(batchWidth(rows), (isScalar ? scalarColumns : 5 * k) - next_);
  rhs_.resize(rows, width);
  // A face's numbers of θ follow each other, and so do its columns.
  const auto at = [&](Index row, Index column) -> double& {
    if (next_ + column < 3 * k) return columns_->data()[static_cast<std::size_t>(row) * 3 * k + next_ + column];
    if (isScalar) return (*columns_)(3 * faces_ + row, next_ + column - 3 * k);
    return (*columns_)(4 * faces_ + row, next_ + column - scalarColumns);
  };
  for (Index row = 0; row < rows; ++row) {
    for (Index column = 0; column < width; ++column) rhs_(row, column) = at(row, column);
  }
  SparseCholesky& factor = isScalar ? scalarFactor_ : deviatorFactor_;
  solution_.setZero(rows, width);
  const Status status =
      factor.solveRefined(isScalar ? scalar_ : deviator_, rhs_, solution_, isRough_ ? kRoughSolve : kSolve);
  for (Index row = 0; row < rows; ++row) {
    for (Index column = 0; column < width; ++column) at(row, column) = solution_(row, column);
  }
  next_ += width;
  isDone = next_ == 5 * k;
  if (isDone) takeOffGrowth(false);
  return status;
}

}  // namespace whittle
