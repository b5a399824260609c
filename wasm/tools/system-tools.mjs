import { existsSync } from 'node:fs';
import { findBrowser } from './browsers.mjs';
import { fail, probe, runQuietly } from './run.mjs';

const eigenFolders = ['/usr/include/eigen3', '/usr/local/include/eigen3', '/opt/homebrew/include/eigen3'];
const doctestFolders = [
  '/usr/include/doctest',
  '/usr/local/include/doctest',
  '/opt/homebrew/include/doctest',
];

/** What the system has to bring, for which purposes, how to see that it is there, and what packages hold it. */
const tools = [
  { name: 'em++', for: 'wasm', found: () => probe('em++'), apt: 'emscripten', brew: 'emscripten' },
  {
    name: 'Eigen',
    for: 'wasm',
    found: () => eigenFolders.some(existsSync),
    apt: 'libeigen3-dev',
    brew: 'eigen',
  },
  { name: 'CMake', for: 'wasm', found: () => probe('cmake'), apt: 'cmake', brew: 'cmake' },
  { name: 'Ninja', for: 'wasm', found: () => probe('ninja'), apt: 'ninja-build', brew: 'ninja' },
  { name: 'a C++20 compiler', for: 'native', found: () => probe('c++'), apt: 'g++', brew: 'llvm' },
  {
    name: 'doctest',
    for: 'native',
    found: () => doctestFolders.some(existsSync),
    apt: 'doctest-dev',
    brew: 'doctest',
  },
  {
    name: 'clang-format',
    for: 'format',
    found: () => probe('clang-format'),
    apt: 'clang-format',
    brew: 'clang-format',
  },
  {
    name: 'Chromium',
    for: 'chromium',
    found: () => findBrowser('chromium'),
    apt: 'chromium',
    brew: '--cask chromium',
  },
  {
    name: 'Firefox',
    for: 'firefox',
    found: () => findBrowser('firefox'),
    apt: 'firefox-esr',
    brew: '--cask firefox',
  },
  // Without a screen Firefox has no WebGL.
  {
    name: 'Xvfb',
    for: 'firefox',
    found: () => process.platform !== 'linux' || probe('which', ['Xvfb']),
    apt: 'xvfb',
  },
];

/** Installs what the given purposes miss, where the package manager does so without asking; else says what to install. */
export function requireTools(purposes) {
  const missing = tools.filter((tool) => purposes.includes(tool.for) && !tool.found());
  if (missing.length === 0) return;
  const names = missing.map((tool) => tool.name).join(', ');
  const apt = missing.map((tool) => tool.apt);
  const asRoot = process.getuid?.() === 0 ? [] : ['sudo', '-n'];
  if (probe('apt-get') && (asRoot.length === 0 || probe('sudo', ['-n', 'true']) !== undefined)) {
    const install = [...asRoot, 'apt-get'];
    runQuietly('Refreshing the package list', install[0], [...install.slice(1), 'update', '-q']);
    const args = [...install.slice(1), 'install', '-y', '-q', '--no-install-recommends', ...apt];
    runQuietly(`Installing ${names}`, install[0], args, { DEBIAN_FRONTEND: 'noninteractive' });
  } else if (probe('brew')) {
    for (const tool of missing)
      runQuietly(`Installing ${tool.name}`, 'brew', ['install', ...tool.brew.split(' ')]);
  }
  const still = missing.filter((tool) => !tool.found());
  if (still.length === 0) return;
  const packages = still.map((tool) => tool.apt).join(' ');
  fail(
    `Please install ${still.map((tool) => tool.name).join(', ')} and run this again; on Debian or Ubuntu: sudo apt-get install ${packages}`,
  );
}
