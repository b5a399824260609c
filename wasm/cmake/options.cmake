# Options that every target of the core shares, and what depends on the compiler.

# Eigen is headers only; it lives in the host's include path even when compiling to wasm.
find_path(EIGEN_INCLUDE Eigen/Core PATH_SUFFIXES eigen3
          PATHS /usr/include /usr/local/include /opt/homebrew/include NO_CMAKE_FIND_ROOT_PATH REQUIRED)

add_library(whittle_options INTERFACE)
target_include_directories(whittle_options SYSTEM INTERFACE ${EIGEN_INCLUDE})
target_compile_definitions(whittle_options INTERFACE EIGEN_MPL2_ONLY)
# No contraction: a multiply-add fused on one machine and not on another would give other bits.
target_compile_options(whittle_options INTERFACE -Wall -Wextra -Wno-psabi -fno-exceptions -ffp-contract=off)

if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  # By default the compiler looks for garbage from 100 MB on, and finds little of it among Eigen's templates.
  target_compile_options(whittle_options INTERFACE --param=ggc-min-heapsize=524288)
endif()

option(WHITTLE_SANITIZE "Build with AddressSanitizer and UndefinedBehaviorSanitizer" OFF)
if(WHITTLE_SANITIZE)
  target_compile_options(whittle_options INTERFACE -fsanitize=address,undefined -fno-sanitize-recover=all
                                                   -fno-omit-frame-pointer)
  target_link_options(whittle_options INTERFACE -fsanitize=address,undefined)
endif()

if(EMSCRIPTEN)
  execute_process(COMMAND ${CMAKE_CXX_COMPILER} -dumpversion OUTPUT_VARIABLE WHITTLE_EMSCRIPTEN_VERSION
                  OUTPUT_STRIP_TRAILING_WHITESPACE)
  # Clang 14's SLP vectorizer miscompiled double-precision code for wasm SIMD; the hot kernels are vectorized by hand.
  # Bulk memory: filling and copying by the engine instead of loops; whatever runs SIMD has it.
  target_compile_options(whittle_options INTERFACE -O3 -msimd128 -mbulk-memory -fno-slp-vectorize)
  # Newer versions default to 64 KB, in which Eigen's temporaries do not fit.
  if(WHITTLE_EMSCRIPTEN_VERSION VERSION_LESS 3.1.27)
    set(WHITTLE_STACK -sTOTAL_STACK=1MB)
  else()
    set(WHITTLE_STACK -sSTACK_SIZE=1MB)
  endif()
  # By default wasm-opt moves every function that has one caller into it. The giants that come of it run in the browser's quick
  # and slow code to their end, while it compiles them well, for longer than they run and for nothing: it cannot exchange the code
  # of a function that runs. Small functions are compiled in no time and exchanged at the next call.
  set(WHITTLE_INLINING -sBINARYEN_EXTRA_PASSES=--one-caller-inline-max-function-size=20)
  set(WHITTLE_WASM_LINK -O3 -mbulk-memory -sALLOW_MEMORY_GROWTH=1 -sMEMORY_GROWTH_LINEAR_STEP=4MB -sINITIAL_MEMORY=64MB -sMAXIMUM_MEMORY=4GB ${WHITTLE_STACK}
      ${WHITTLE_INLINING})
endif()
