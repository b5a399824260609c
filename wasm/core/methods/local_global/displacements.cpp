#include "methods/local_global/displacements.h"

namespace whittle {

void Displacements::measure(const Points& positions, const Points& rest) {
  for (Index v = 0; v < rest.rows(); ++v) setRow(rows_[v], (positions.row(v) - rest.row(v)).transpose());
  setExact([&](Index, Index v) -> Eigen::RowVector3d { return positions.row(v) - rest.row(v); });
}

void Displacements::apply(const Points& rest, Points& positions) const {
  for (Index v = 0; v < rest.rows(); ++v) {
    const LaneRow& d = rows_[v];
    positions.row(v) = rest.row(v) + Eigen::RowVector3d(d.x, d.y, d.z);
  }
  for (Index place = 0; place < exact_.rows(); ++place) {
    const Index v = stiff_->vertices()[place];
    positions.row(v) = rest.row(v) + exact_.row(place);
  }
}

void Displacements::combine(const Displacements& a, double s, const Displacements& b, const Displacements& c) {
  const float share = static_cast<float>(s);
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    store(&rows_[i], load(&a.rows_[i]) + share * (load(&b.rows_[i]) - load(&c.rows_[i])));
  }
  setExact([&](Index place, Index) -> Eigen::RowVector3d {
    return a.exact_.row(place) + s * (b.exact_.row(place) - c.exact_.row(place));
  });
}

}  // namespace whittle
