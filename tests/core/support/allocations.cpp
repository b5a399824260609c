#include "support/allocations.h"

#include <cstdlib>
#include <new>

namespace {
long count = 0;
}

extern "C" void* __real_malloc(std::size_t size);

// The linker sends every call of malloc in our own objects here (--wrap); Eigen's are among them.
extern "C" void* __wrap_malloc(std::size_t size) {
  ++count;
  return __real_malloc(size);
}

void* operator new(std::size_t size) {
  if (void* memory = malloc(size ? size : 1)) return memory;
  std::abort();
}

void* operator new(std::size_t size, const std::nothrow_t&) noexcept { return malloc(size ? size : 1); }

void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete(void* memory, const std::nothrow_t&) noexcept { std::free(memory); }

namespace whittle::testing {

long allocationCount() { return count; }

}  // namespace whittle::testing
