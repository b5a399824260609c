import { existsSync } from 'node:fs';
import { probe, runQuietly } from './run.mjs';
import { fingerprint, isFresh, markFresh } from './stamps.mjs';

const sources = ['wasm/CMakeLists.txt', 'wasm/cmake', 'wasm/core', 'wasm/bindings'];
const testSources = [...sources, 'wasm/yardstick', 'tests/core'];

/** Builds the wasm module into wasm/dist. */
export function buildWasm() {
  const state = fingerprint(sources, probe('em++')?.split('\n')[0]);
  if (existsSync('wasm/dist/whittle-core.wasm') && isFresh('wasm', state)) return;
  configureAndBuild('Building the core as wasm', 'wasm/build/wasm', [], 'emcmake');
  markFresh('wasm', state);
}

/** Builds the C++ tests: natively with sanitizers and Eigen's own checks, and as wasm for Node. */
export function buildTests() {
  const state = fingerprint(testSources, probe('c++')?.split('\n')[0]);
  if (existsSync('wasm/build/native-tests') && isFresh('native-tests', state)) return;
  const checked = ['-DCMAKE_BUILD_TYPE=Debug', '-DCMAKE_CXX_FLAGS_DEBUG=-O1 -g1', '-DWHITTLE_SANITIZE=ON'];
  configureAndBuild('Building the C++ tests with sanitizers', 'wasm/build/native-tests', [
    '-DWHITTLE_TESTS=ON',
    ...checked,
  ]);
  configureAndBuild(
    'Building the C++ tests as wasm',
    'wasm/build/wasm-tests',
    ['-DWHITTLE_TESTS=ON'],
    'emcmake',
  );
  markFresh('native-tests', state);
}

/** Builds the native benchmark for this very processor. */
export function buildBenchmark() {
  const state = fingerprint([...sources, 'wasm/bench'], probe('c++')?.split('\n')[0]);
  if (existsSync('wasm/build/native-bench') && isFresh('native-bench', state)) return;
  const options = ['-DWHITTLE_BENCH=ON', '-DCMAKE_CXX_FLAGS=-O3 -march=native'];
  configureAndBuild('Building the native benchmark', 'wasm/build/native-bench', options);
  markFresh('native-bench', state);
}

function configureAndBuild(announcement, folder, options, wrapper) {
  // Debian's em++ finds its JavaScript tools only through NODE_PATH.
  const env = existsSync('/usr/share/nodejs') ? { NODE_PATH: '/usr/share/nodejs' } : {};
  const cmake = ['cmake', '-S', 'wasm', '-B', folder, '-G', 'Ninja', ...options];
  const [command, ...args] = wrapper ? [wrapper, ...cmake] : cmake;
  runQuietly(announcement, command, args, env);
  runQuietly(`${announcement}: compiling`, 'cmake', ['--build', folder], env);
}
