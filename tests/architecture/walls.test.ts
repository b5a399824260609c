import { readFileSync } from 'node:fs';
import { describe, expect, test } from 'vitest';
import { methods } from '../../src/methods/registry.ts';
import { filesBelow } from './imports.ts';

const sources = [
  ...filesBelow('src', /\.ts$/),
  ...filesBelow('web', /\.(ts|css)$/),
  ...filesBelow('wasm/core', /\.(h|cpp)$/),
];

describe('walls of the house', () => {
  test('no file is longer than 400 lines', () => {
    for (const file of [...sources, ...filesBelow('tests', /\.(ts|cpp|h)$/)])
      expect(readFileSync(file, 'utf8').split('\n').length, file).toBeLessThanOrEqual(401);
  });

  test('no function is longer than one can read at once: 60 lines of C++, 60 of TypeScript', () => {
    for (const file of sources.filter((name) => !name.endsWith('.css')))
      for (const { name, lines } of functionsOf(readFileSync(file, 'utf8')))
        expect(lines, `${file}: ${name}`).toBeLessThanOrEqual(60);
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

  test('no Emscripten in the core', () => {
    for (const file of filesBelow('wasm/core', /\.(h|cpp)$/))
      expect(readFileSync(file, 'utf8'), file).not.toMatch(/emscripten/i);
  });

  test.each(['vector', 'rotation', 'rotations', 'scalars', 'handles', 'chains'])(
    'the kind of value “%s” is known to its own file and its table alone',
    (kind) => {
      const quoted = new RegExp(`['"\`]${kind}['"\`]`);
      // Descriptors name the kinds of their parameters; all else goes through the table.
      const descriptors = /^src\/methods\/[a-z-]+\.ts$/;
      const files = [...filesBelow('src', /\.ts$/), ...filesBelow('web', /\.ts$/)].filter(
        (file) => !descriptors.test(file),
      );
      const known = files.filter((file) => quoted.test(code(readFileSync(file, 'utf8'))));
      expect(known).toEqual([`src/methods/values/${kind}.ts`]);
      const core = filesBelow('wasm/core', /\.(h|cpp)$/).filter((file) =>
        new RegExp(`"${kind}"`).test(readFileSync(file, 'utf8')),
      );
      for (const file of core) expect(file).toMatch(/^wasm\/core\/methods\//);
    },
  );

  test('no method’s id stands in the page', () => {
    const ids = new RegExp(`['"\`](${methods.map(({ id }) => id).join('|')})['"\`]`);
    for (const file of filesBelow('web', /\.ts$/))
      expect(code(readFileSync(file, 'utf8')), file).not.toMatch(ids);
  });

  test('no DOM in editor, inputs, recipe and all below: the types that they are checked with have none', () => {
    const { compilerOptions, include } = JSON.parse(readFileSync('tsconfig.json', 'utf8'));
    expect(compilerOptions.lib).toEqual(['ES2023', 'WebWorker']);
    for (const room of [
      'editor',
      'inputs',
      'recipe',
      'measures',
      'selection',
      'engine',
      'io',
      'methods',
      'mesh',
    ])
      expect(include).toContain(`src/${room}`);
  });
});

/** The text without comments. */
function code(text: string): string {
  return text.replaceAll(/\/\*[\s\S]*?\*\/|\/\/.*$/gm, '');
}

/** Functions and methods by their first line, as long as the indentation says: our formatters keep it true. */
function functionsOf(text: string): { name: string; lines: number }[] {
  const lines = text.split('\n');
  const found: { name: string; lines: number }[] = [];
  for (const [at, line] of lines.entries()) {
    const opening =
      /^(\s*)(?!\w+_[({]|if|for|while|switch|else|do\b|namespace|class|struct|enum|export (?:const|class|interface))[^\s/*].*\)[^;]*\{$/.exec(
        line,
      );
    if (!opening) continue;
    const end = lines.findIndex((other, k) => k > at && other.startsWith(`${opening[1]}}`));
    if (end > 0) found.push({ name: line.trim(), lines: end - at + 1 });
  }
  return found;
}
