// Times the core against the reference on one mesh, in one process, and prints the numbers as JSON (times in ms, memory
// in bytes).
//
// usage: whittle-bench METHOD MESH SECONDS
//
// METHOD is one that `readProblem` has a problem for. MESH is a file as it wants it. SECONDS bounds the long run of the
// core; that of the reference, where there is one, gets twice as many. Or METHOD is `reshape`, which has shapes of its
// own: MESH is then about how many faces they are to have, and SECONDS bounds the run of the reference.

#include "bench/alone.h"
#include "bench/descent.h"
#include "bench/phases.h"
#include "bench/reshape_runs.h"

using namespace whittle;
using namespace whittle::bench;

namespace {

#ifdef __clang__
constexpr const char* kCompiler = __VERSION__;
#else
constexpr const char* kCompiler = "g++ " __VERSION__;
#endif

constexpr double kPermille = 1.001;  // of the converged energy
constexpr int kFixedCount = 20;      // iterations after which builds are compared

/// Iterations and time to a share above E*.
Json toWithin(const Descent& run, double lowest, double share) {
  const int count = run.iterationsTo((1 + share) * lowest);
  return Json().add("iterations", count).add("time", count < 0 ? -1 : run.times[count]);
}

Json describe(const Descent& run, double lowest) {
  // The energy after the last iteration is not known where the run ended there.
  const int stop = run.stop >= 0 && run.stop < static_cast<int>(run.energies.size()) ? run.stop : -1;
  Json atStop;
  atStop.add("iterations", stop).add("time", stop < 0 ? -1 : run.times[stop]);
  atStop.add("aboveLowest", stop < 0 ? -1 : run.energies[stop] / lowest - 1);
  return Json()
      .add("iterations", static_cast<double>(run.energies.size()) - 1)
      .add("time", run.times.back())
      .add("rested", run.rested)
      .add("aboveLowest", run.energies.back() / lowest - 1)
      .add("toPercent", toWithin(run, lowest, 0.01))
      .add("toPermille", toWithin(run, lowest, 0.001))
      .add("stop", atStop);
}

/// The core beside the reference.
void compare(const Problem& problem, double seconds, Json& result) {
  // First of all the core, cold: a fresh process, as a person who opens the page has it.
  const Descent ours = descend(problem, seconds);
  const double memory = peakMemory();
  const Descent plain = descendPlainly(problem, 2 * seconds, kPermille * ours.lowest());
  const double lowest = std::min(ours.lowest(), plain.lowest());
  const Descent warm = descend(problem, seconds, kPermille * lowest);

  result.add("memory", memory);
  result.add("lowest", lowest);
  result.add("energyAtFixedCount", ours.energies[std::min<std::size_t>(kFixedCount, ours.energies.size() - 1)]);
  result.add("cold", describe(ours, lowest));
  result.add("warm", describe(warm, lowest));
  result.add("plain", describe(plain, lowest));
  result.add("phases", measurePhases(problem, seconds / 2));
}

}  // namespace

int main(int argc, char** argv) {
  const std::string method = argc == 4 ? argv[1] : "";
  if (method == "reshape") {
    const Json result = measureReshape(std::atoi(argv[2]), std::atof(argv[3]));
    std::printf("%s\n", Json(result).add("compiler", std::string(kCompiler)).text().c_str());
    return 0;
  }
  const auto& names = problemNames();
  if (std::find(names.begin(), names.end(), method) == names.end()) {
    require(Status::failure(Code::badParameter, "usage: whittle-bench METHOD MESH SECONDS"));
  }
  const Problem problem = readProblem(method, argv[2]);
  const double seconds = std::atof(argv[3]);
  Json result;
  result.add("vertices", problem.mesh.vertexCount()).add("faces", problem.mesh.faceCount());
  result.add("compiler", std::string(kCompiler));
  if (problem.hasPlainPath()) {
    compare(problem, seconds, result);
  } else {
    result.add("alone", measureAlone(problem, seconds)).add("memory", peakMemory());
  }
  std::printf("%s\n", result.text().c_str());
  return 0;
}
