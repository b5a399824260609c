#include "session/preparation.h"

namespace whittle {

Status Preparation::advance() {
  if (isDone()) return {};
  double done = 1;
  Status status = stages_[next_].run(done);
  if (!status.ok()) return status;
  done_ = done;
  if (done >= 1) {
    ++next_;
    done_ = 0;
  }
  return {};
}

double Preparation::share() const {
  if (isDone()) return 1;
  double sum = 0, finished = 0;
  for (std::size_t s = 0; s < stages_.size(); ++s) {
    sum += stages_[s].weight;
    if (s < next_) finished += stages_[s].weight;
  }
  return (finished + done_ * stages_[next_].weight) / sum;
}

}  // namespace whittle
