#pragma once

#include <optional>
#include <vector>

#include "methods/alternating/alternation.h"

namespace whittle {

/// What a run came to for these targets of the handles.
struct GestureEnd {
  std::vector<Vec3> targets;
  Points positions;  // #V×3
};

/// The run from rest that goes on behind a drag, an iteration now and then, for targets that are a moment old. Where it
/// ended is what later answers start from: such as start from one another slide away along flat sides, where the energy
/// hardly tells one place from the other.
class RunBehind {
 public:
  /// Begins with the systems as they are aimed now, which the caller keeps.
  void begin(const RestSurface& surface, const EnergyWeights& weights, VertexSystem& vertices,
             TransformationSystem& transformations, const AlternationLimits& limits, std::vector<Vec3> targets);
  /// Ends it without a result; what it came to before stays known.
  void stop() { state_ = State::none; }
  /// Stops it and forgets what it came to.
  void forget();
  bool isGoing() const { return state_ == State::going; }
  /// Whether it ended by itself.
  bool hasEnded() const { return state_ == State::ended; }
  /// Targets of the handles that it is for.
  const std::vector<Vec3>& targets() const { return targets_; }

  /// Lets it go on after other runs have used the systems, which are aimed at its own targets again.
  void takeUp() { alternation_.takeUp(); }
  /// Does a slice of an iteration. A run that loses its numbers is stopped.
  /// @returns whether the iteration is whole
  bool iterate();

  /// Notes the end of another run from rest.
  void note(GestureEnd end) { end_ = std::move(end); }
  /// The last end whose faces do not fold.
  const std::optional<GestureEnd>& end() const { return end_; }
  bool isEndOf(const std::vector<Vec3>& targets) const { return end_ && end_->targets == targets; }

 private:
  enum class State { none, going, ended };

  const RestSurface* surface_ = nullptr;
  Alternation alternation_;
  State state_ = State::none;
  std::vector<Vec3> targets_;
  std::optional<GestureEnd> end_;
};

}  // namespace whittle
