#pragma once

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "base/json.h"
#include "base/status.h"

namespace whittle::bench {

/// The most memory so far, in bytes: pages of the wasm memory, which never shrinks, or the process's resident set.
double peakMemory();

inline double milliseconds() {
  using namespace std::chrono;
  return duration<double, std::milli>(steady_clock::now().time_since_epoch()).count();
}

template <typename Work>
double timed(Work&& work) {
  const double start = milliseconds();
  work();
  return milliseconds() - start;
}

/// Times of one piece of work, in ms.
class Samples {
 public:
  void add(double time) { times_.push_back(time); }
  double median() const {
    std::vector<double> sorted = times_;
    std::sort(sorted.begin(), sorted.end());
    return sorted.empty() ? 0 : sorted[sorted.size() / 2];
  }

 private:
  std::vector<double> times_;
};

/// One phase of both sides, round by round. The ratio is taken within each round: load that comes and goes meets both.
class Comparison {
 public:
  void add(double ours, double plain) {
    ours_.add(ours);
    plain_.add(plain);
    if (ours > 0) ratio_.add(plain / ours);
  }
  Json json() const {
    return Json().add("ours", ours_.median()).add("plain", plain_.median()).add("ratio", ratio_.median());
  }

 private:
  Samples ours_, plain_, ratio_;
};

/// Ends the program with a sentence where something failed: a number that is not there is no number.
inline void require(const Status& status) {
  if (status.ok()) return;
  std::fprintf(stderr, "%s: %s\n", codeName(status.code), status.message.c_str());
  std::exit(1);
}

}  // namespace whittle::bench
