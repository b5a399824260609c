import { readFileSync } from 'node:fs';
import { describe, expect, test } from 'vitest';
import { arrowsOf, circlesOf, filesBelow, roomOf } from './imports.ts';

/** Which rooms a room may import from (the README's layout). What is not listed is forbidden. */
const typescriptArrows: Record<string, string[]> = {
  'src/mesh': [],
  'src/methods': ['src/mesh'],
  'src/io': ['src/mesh'],
  'src/inputs': ['src/io', 'src/methods', 'src/mesh'],
  'src/engine': ['src/io', 'src/methods', 'src/mesh', 'wasm/dist'],
  'src/recipe': ['src/inputs', 'src/engine', 'src/methods', 'src/mesh'],
  'src/measures': ['src/inputs', 'src/methods', 'src/mesh'],
  'src/selection': ['src/mesh'],
  'src/painting': ['src/selection', 'src/inputs', 'src/mesh'],
  'src/viewer': ['src/mesh'],
  'src/editor': [
    'src/recipe',
    'src/measures',
    'src/inputs',
    'src/engine',
    'src/io',
    'src/methods',
    'src/mesh',
  ],
  'src/element': [
    'src/editor',
    'src/viewer',
    'src/recipe',
    'src/engine',
    'src/io',
    'src/methods',
    'src/mesh',
  ],
  'src/cli': ['src/recipe', 'src/engine', 'src/io', 'src/methods', 'src/mesh'],
  web: [
    'src/editor',
    'src/viewer',
    'src/selection',
    'src/painting',
    'src/measures',
    'src/recipe',
    'src/inputs',
    'src/engine',
    'src/io',
    'src/methods',
    'src/mesh',
  ],
};

const coreArrows: Record<string, string[]> = {
  base: [],
  simd: ['base'],
  mesh: ['base'],
  geometry: ['mesh', 'simd', 'base'],
  linear: ['simd', 'base'],
  targets: ['geometry', 'mesh', 'simd', 'base'],
  constraints: ['geometry', 'linear', 'mesh', 'simd', 'base'],
  remeshing: ['geometry', 'mesh', 'simd', 'base'],
  optimization: ['linear', 'simd', 'base'],
  methods: [
    'constraints',
    'targets',
    'remeshing',
    'optimization',
    'linear',
    'geometry',
    'mesh',
    'simd',
    'base',
  ],
  session: ['methods', 'constraints', 'targets', 'mesh', 'base'],
};

describe('arrows of the house', () => {
  const rooms = Object.keys(typescriptArrows);

  test.each(rooms)('%s imports only what it may', (room) => {
    const files = filesBelow(room, /\.ts$/);
    expect(files.length).toBeGreaterThan(0);
    for (const file of files) {
      for (const target of arrowsOf(file)) {
        const other = roomOf(target, [...rooms, 'wasm/dist']) ?? target;
        expect([room, ...typescriptArrows[room]!], `${file} imports ${target}`).toContain(other);
      }
    }
  });

  test('no file imports itself by way of others', () => {
    expect(circlesOf([...filesBelow('src', /\.ts$/), ...filesBelow('web', /\.ts$/)])).toEqual([]);
  });

  test.each(Object.keys(coreArrows))('core/%s includes only what it may', (room) => {
    const files = filesBelow(`wasm/core/${room}`, /\.(h|cpp)$/);
    expect(files.length).toBeGreaterThan(0);
    for (const file of files) {
      for (const [, target] of readFileSync(file, 'utf8').matchAll(/#include "([^"]+)"/g)) {
        expect([room, ...coreArrows[room]!], `${file} includes ${target}`).toContain(target!.split('/')[0]);
      }
    }
  });

  test('who uses core/linear includes its doors and nothing of its inside', () => {
    const doors = [
      'sparse_cholesky',
      'conjugate_gradients',
      'lane_gradients',
      'matrix_field_system',
      'vector_field_system',
      'constrained_quadratic',
      'ordering',
      'elimination_tree', // for the order of the vertices
      'graph',
      'columns',
      'slices',
      'row_planes',
      'symmetric_blocks',
    ].map((name) => `linear/${name}.h`);
    const users = ['wasm/core', 'wasm/bindings', 'wasm/bench'].flatMap((folder) =>
      filesBelow(folder, /\.(h|cpp)$/),
    );
    const inside = 'wasm/core/linear/';
    for (const file of users.filter((name) => !name.startsWith(inside))) {
      for (const [, target] of readFileSync(file, 'utf8').matchAll(/#include "(linear\/[^"]+)"/g)) {
        expect(doors, `${file} includes ${target}`).toContain(target);
      }
    }
    for (const door of doors) {
      for (const [, target] of readFileSync(`wasm/core/${door}`, 'utf8').matchAll(
        /#include "(linear\/[^"]+)"/g,
      )) {
        expect(doors, `${door} shows ${target}`).toContain(target);
      }
    }
  });
});
