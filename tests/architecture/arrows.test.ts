import { readdirSync, readFileSync } from 'node:fs';
import { dirname, join, normalize } from 'node:path';
import { describe, expect, test } from 'vitest';

/** Which rooms a room may import from (DESIGN §1). What is not listed is forbidden. */
const typescriptArrows: Record<string, string[]> = {
  'src/mesh': [],
  'src/methods': [],
  'src/styles': ['src/mesh', 'src/methods'],
  'src/textures': ['src/styles', 'src/mesh', 'src/methods'],
  'src/io': ['src/mesh'],
  'src/recipe': ['src/methods', 'src/mesh'],
  'src/engine': ['src/io', 'src/methods', 'src/mesh', 'wasm/dist'],
  'src/viewer': ['src/mesh'],
  'src/cli': ['src/engine', 'src/recipe', 'src/io', 'src/styles', 'src/textures', 'src/methods', 'src/mesh'],
  web: [
    'src/engine',
    'src/viewer',
    'src/recipe',
    'src/styles',
    'src/textures',
    'src/methods',
    'src/mesh',
    'src/io',
  ],
};

const coreArrows: Record<string, string[]> = {
  base: [],
  mesh: ['base'],
  geometry: ['mesh', 'base'],
  linear: ['base'],
  constraints: ['mesh', 'base'],
  methods: ['constraints', 'linear', 'geometry', 'mesh', 'base'],
  session: ['methods', 'constraints', 'mesh', 'base'],
};

function filesBelow(folder: string, ending: RegExp): string[] {
  return readdirSync(folder, { recursive: true, encoding: 'utf8' })
    .filter((name) => ending.test(name) && !name.includes('node_modules'))
    .map((name) => join(folder, name));
}

function roomOf(path: string, rooms: Iterable<string>): string | undefined {
  return [...rooms].find((room) => path.startsWith(`${room}/`));
}

describe('arrows of the house', () => {
  const rooms = Object.keys(typescriptArrows);

  test.each(rooms)('%s imports only what it may', (room) => {
    const files = filesBelow(room, /\.ts$/);
    expect(files.length).toBeGreaterThan(0);
    for (const file of files) {
      const text = readFileSync(file, 'utf8');
      for (const [, target] of text.matchAll(/(?:from|import|import\()\s*'(\.[^']+)'/g)) {
        const path = normalize(join(dirname(file), target!));
        const other = roomOf(path, [...rooms, 'wasm/dist']) ?? path;
        expect([room, ...typescriptArrows[room]!], `${file} imports ${target}`).toContain(other);
      }
    }
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
      'constrained_quadratic',
      'ordering',
      'elimination_tree', // for the order of the vertices
      'graph',
      'columns',
      'slices',
      'row_planes',
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

  test('only engine/wasm-heap.ts touches the wasm heap, only the core and its wasm files call the C interface', () => {
    const heap = /^src\/engine\/wasm-(heap|module)\.ts$/; // the module only declares it
    const callers = /^src\/engine\/(core|wasm-[a-z]+)\.ts$/;
    for (const file of filesBelow('src', /\.ts$/)) {
      const text = readFileSync(file, 'utf8');
      if (!heap.test(file)) expect(text, file).not.toMatch(/HEAP(U8|F64|32)|_malloc|\b_free/);
      if (!callers.test(file)) expect(text, file).not.toMatch(/_whittle_/);
    }
  });

  test('no Emscripten in the core, no file over the wall', () => {
    for (const file of filesBelow('wasm/core', /\.(h|cpp)$/)) {
      expect(readFileSync(file, 'utf8'), file).not.toMatch(/emscripten/i);
    }
    const all = [
      ...filesBelow('src', /\.ts$/),
      ...filesBelow('web', /\.(ts|css)$/),
      ...filesBelow('wasm/core', /\.(h|cpp)$/),
      ...filesBelow('tests', /\.(ts|cpp|h)$/),
    ];
    for (const file of all)
      expect(readFileSync(file, 'utf8').split('\n').length, file).toBeLessThanOrEqual(401);
  });
});
