import { copyFileSync, existsSync } from 'node:fs';
import { probe, runQuietly } from './run.mjs';
import { fingerprint, isFresh, markFresh } from './stamps.mjs';

const sources = ['wasm/CMakeLists.txt', 'wasm/cmake', 'wasm/core', 'wasm/bindings'];
const programs = [
  'wasm/build/native-bench/bench/whittle-bench',
  'wasm/build/wasm-bench/bench/whittle-bench.cjs',
];
const testPrograms = [
  'wasm/build/native-tests/tests/whittle-core-tests',
  'wasm/build/wasm/tests/whittle-core-tests.cjs',
];
const testSources = [...sources, 'wasm/reference', 'tests/core'];

/** Builds the wasm module into wasm/dist; Draco's decoder comes beside it, where the worker finds it. */
export function buildWasm() {
  const state = fingerprint(sources, probe('em++')?.split('\n')[0]);
  if (!existsSync('wasm/dist/whittle-core.wasm') || !isFresh('wasm', state)) {
    configureAndBuild('Building the core as wasm', 'wasm/build/wasm', [], 'emcmake', 'whittle-core');
    markFresh('wasm', state);
  }
  copyFileSync('node_modules/draco3d/draco_decoder.wasm', 'wasm/dist/draco_decoder.wasm');
}

/** Builds the C++ tests: natively with sanitizers and Eigen's own checks, and as wasm for Node. */
export function buildTests() {
  const state = fingerprint(testSources, probe('c++')?.split('\n')[0]);
  if (testPrograms.every(existsSync) && isFresh('native-tests', state)) return;
  const checked = ['-DCMAKE_BUILD_TYPE=Debug', '-DCMAKE_CXX_FLAGS_DEBUG=-O1 -g1', '-DWHITTLE_SANITIZE=ON'];
  configureAndBuild('Building the C++ tests with sanitizers', 'wasm/build/native-tests', [
    '-DWHITTLE_TESTS=ON',
    ...checked,
  ]);
  // They take the core that the module is made of; the module itself is left alone, because something may be running it.
  configureAndBuild(
    'Building the C++ tests as wasm',
    'wasm/build/wasm',
    ['-DWHITTLE_TESTS=ON'],
    'emcmake',
    'whittle-core-tests',
  );
  markFresh('native-tests', state);
}

/** Builds the C++ tests natively as a release is built: optimized, without assertions and sanitizers. */
export function buildReleaseTests() {
  const state = fingerprint(testSources, probe('c++')?.split('\n')[0]);
  if (existsSync('wasm/build/release-tests') && isFresh('release-tests', state)) return;
  const options = ['-DWHITTLE_TESTS=ON', '-DCMAKE_BUILD_TYPE=Release'];
  configureAndBuild('Building the C++ tests as a release', 'wasm/build/release-tests', options);
  markFresh('release-tests', state);
}

/** Builds the benchmark program: natively for this very processor, and as wasm for Node. */
export function buildBenchmark() {
  const compilers = ['c++', 'em++'].map((name) => probe(name)?.split('\n')[0]).join();
  const state = fingerprint([...sources, 'wasm/reference', 'wasm/bench'], compilers);
  if (programs.every(existsSync) && isFresh('bench', state)) return;
  const native = ['-DWHITTLE_BENCH=ON', '-DCMAKE_CXX_FLAGS=-O3 -march=native'];
  const wasm = ['-DWHITTLE_BENCH=ON'];
  configureAndBuild('Building the benchmark', 'wasm/build/native-bench', native, undefined, 'whittle-bench');
  configureAndBuild(
    'Building the benchmark as wasm',
    'wasm/build/wasm-bench',
    wasm,
    'emcmake',
    'whittle-bench',
  );
  markFresh('bench', state);
}

function configureAndBuild(announcement, folder, options, wrapper, target = 'all') {
  // Debian's em++ finds its JavaScript tools only through NODE_PATH.
  const env = existsSync('/usr/share/nodejs') ? { NODE_PATH: '/usr/share/nodejs' } : {};
  const cmake = ['cmake', '-S', 'wasm', '-B', folder, '-G', 'Ninja', ...options];
  const [command, ...args] = wrapper ? [wrapper, ...cmake] : cmake;
  runQuietly(announcement, command, args, env);
  runQuietly(`${announcement}: compiling`, 'cmake', ['--build', folder, '--target', target], env);
}
