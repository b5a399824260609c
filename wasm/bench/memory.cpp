#ifndef __EMSCRIPTEN__
#include <sys/resource.h>
#endif

#include "bench/measure.h"

namespace whittle::bench {

double peakMemory() {
#ifdef __EMSCRIPTEN__
  return 65536.0 * __builtin_wasm_memory_size(0);
#else
  // Where the system tells it: what `getrusage` says begins with the size of the process that started this one.
  if (std::FILE* status = std::fopen("/proc/self/status", "r")) {
    char line[256];
    double kilobytes = 0;
    while (std::fgets(line, sizeof line, status) && std::sscanf(line, "VmHWM: %lf", &kilobytes) != 1) {
    }
    std::fclose(status);
    if (kilobytes > 0) return 1024 * kilobytes;
  }
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return 1024.0 * usage.ru_maxrss;
#endif
}

}  // namespace whittle::bench
