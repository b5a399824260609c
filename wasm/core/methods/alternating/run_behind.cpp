#include "methods/alternating/run_behind.h"

#include <utility>

#include "methods/alternating/fold_check.h"

namespace whittle {

void RunBehind::begin(const RestSurface& surface, const EnergyWeights& weights, VertexSystem& vertices,
                      TransformationSystem& transformations, const AlternationLimits& limits,
                      std::vector<Vec3> targets) {
  alternation_.begin(surface, weights, vertices, transformations, limits);
  surface_ = &surface;
  targets_ = std::move(targets);
  state_ = State::going;
}

void RunBehind::forget() {
  stop();
  end_.reset();
}

bool RunBehind::iterate() {
  StepReport report;
  if (!alternation_.iterate(report).ok()) {
    stop();
    return true;
  }
  if (report.outcome == Outcome::midway) return false;
  if (report.outcome == Outcome::running) return true;
  state_ = State::ended;
  // Where faces fold, the run that counts goes another way.
  if (findFolds(*surface_, alternation_.positions()).isClean()) note({targets_, alternation_.positions()});
  return true;
}

}  // namespace whittle
