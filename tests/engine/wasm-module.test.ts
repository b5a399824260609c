import { expect, test } from 'vitest';
import { requireVersion } from '../../src/engine/wasm-module.ts';

test('a wasm file of another version is refused with what to do', () => {
  const sentence = /^The wasm file is of another version than the program \(\d, not 4\)\. Reload the page/;
  expect(() => requireVersion({ _whittle_abi_version: () => 2 })).toThrow(sentence);
  expect(() => requireVersion({})).toThrow(sentence);
  expect(() => requireVersion({ _whittle_abi_version: () => 4 })).not.toThrow();
});
