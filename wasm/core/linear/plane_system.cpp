#include "linear/plane_system.h"

#include <cmath>

namespace whittle {

namespace {

/// Cosine below which two axes are taken to be perpendicular: what rounding leaves of those that are.
constexpr double kPerpendicular = 1e-12;
/// Share of the work that the analysis is, roughly.
constexpr double kAnalyzed = 0.3;

Vec3 toVector(const LaneRow& row) { return {row.x, row.y, row.z}; }

}  // namespace

void PlaneSystem::beginPrepare(const SparseMatrix& schur) {
  start_.assign(1, 0);
  for (const HeldRow& row : rows_) start_.push_back(start_.back() + row.freedom);
  std::vector<Eigen::Triplet<double, Index>> entries;
  for (Index j = 0; j < schur.cols(); ++j) {
    for (SparseMatrix::InnerIterator entry(schur, j); entry; ++entry) {
      const Index i = static_cast<Index>(entry.row());
      for (int a = 0; a < rows_[i].freedom; ++a) {
        for (int b = 0; b < rows_[j].freedom; ++b) {
          const double cosine = rows_[i].axes[a].dot(rows_[j].axes[b]);
          if (std::abs(cosine) < kPerpendicular) continue;
          entries.emplace_back(start_[i] + a, start_[j] + b, entry.value() * cosine);
        }
      }
    }
  }
  matrix_.resize(start_.back(), start_.back());
  matrix_.setFromTriplets(entries.begin(), entries.end());
  unknowns_.assign(start_.back() + 1, {});
  isAnalyzed_ = false;
  cholesky_.beginAnalyze(matrix_);
}

Status PlaneSystem::prepareNext(double& share, double work) {
  if (!isAnalyzed_) {
    share = kAnalyzed * cholesky_.analyzeNext(work);
    isAnalyzed_ = share == kAnalyzed;
    if (isAnalyzed_) cholesky_.beginFactorize(matrix_);
    return {};
  }
  double done;
  Status status = cholesky_.factorizeNext(done, work);
  share = done == 1 ? 1 : kAnalyzed + (1 - kAnalyzed) * done;
  if (done == 1) matrix_ = SparseMatrix();
  return status;
}

void PlaneSystem::solve(LaneRow* rows) {
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    const Vec3 force = toVector(rows[rows_[i].row]);
    for (int a = 0; a < rows_[i].freedom; ++a) {
      unknowns_[start_[i] + a].x = static_cast<float>(rows_[i].axes[a].dot(force));
    }
  }
  cholesky_.solve(unknowns_.data());
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    Vec3 move = Vec3::Zero();
    for (int a = 0; a < rows_[i].freedom; ++a) move += unknowns_[start_[i] + a].x * rows_[i].axes[a];
    rows[rows_[i].row] = {static_cast<float>(move.x()), static_cast<float>(move.y()), static_cast<float>(move.z()), 0};
  }
}

}  // namespace whittle
