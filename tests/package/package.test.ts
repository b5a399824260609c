import { execFileSync } from 'node:child_process';
import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { afterAll, beforeAll, expect, test } from 'vitest';
import { objText } from '../fixtures/mesh-files.ts';
import { icosphere } from '../fixtures/meshes.ts';

const root = fileURLToPath(new URL('../..', import.meta.url));
let folder: string;

const run = (command: string, ...args: string[]) =>
  execFileSync(command, args, { cwd: folder, encoding: 'utf8', stdio: ['ignore', 'pipe', 'pipe'] });

/** The package as npm packs it, in a folder that has nothing else. */
beforeAll(() => {
  folder = mkdtempSync(join(tmpdir(), 'whittle-package-'));
  const packed = execFileSync('npm', ['pack', '--ignore-scripts', '--silent', '--pack-destination', folder], {
    cwd: root,
    encoding: 'utf8',
  });
  writeFileSync(join(folder, 'package.json'), '{ "name": "user", "private": true, "type": "module" }');
  writeFileSync(join(folder, 'ball.obj'), objText(icosphere(2)));
  run('npm', 'install', '--no-audit', '--no-fund', '--prefer-offline', `./${packed.trim()}`);
});
afterAll(() => rmSync(folder, { recursive: true, force: true }));

test('runs recipes from Node, without a DOM and without a worker', () => {
  writeFileSync(
    join(folder, 'use.js'),
    `import { readFileSync } from 'node:fs';
     import { createEngine, methods, parseRecipe, readMesh, runRecipe, writeMesh } from 'whittle';
     const bytes = new Uint8Array(readFileSync('ball.obj'));
     const read = readMesh(bytes, 'ball.obj');
     const engine = createEngine();
     const recipe = parseRecipe('{"whittle": 1, "steps": [{"method": "cubic", "lambda": 0.4}]}', 'recipe');
     const { mesh, steps } = await runRecipe(engine, read, recipe);
     engine.dispose();
     const text = new TextDecoder().decode(writeMesh(bytes, 'ball.obj', 'obj', mesh.positions).bytes);
     console.log(JSON.stringify({ outcome: steps[0].outcome, methods: methods.length, lines: text.split('\\n').length }));`,
  );
  const said = JSON.parse(run('node', 'use.js'));
  expect(said).toMatchObject({ outcome: 'converged', lines: objText(icosphere(2)).split('\n').length });
  expect(said.methods).toBeGreaterThan(5);
});

test('gives the bytes of its command line', () => {
  run('npx', 'whittle', 'cubic', 'ball.obj', '--lambda', '0.4', '--out', 'line.obj');
  run(
    'node',
    '--input-type=module',
    '-e',
    `import { readFileSync, writeFileSync } from 'node:fs';
     import { createEngine, readMesh, runRecipe, writeMesh } from 'whittle';
     const bytes = new Uint8Array(readFileSync('ball.obj'));
     const engine = createEngine();
     const steps = [{ method: 'cubic', parameters: { lambda: 0.4 } }];
     const { mesh } = await runRecipe(engine, readMesh(bytes, 'ball.obj'), { steps });
     writeFileSync('module.obj', writeMesh(bytes, 'ball.obj', 'obj', mesh.positions).bytes);
     engine.dispose();`,
  );
  expect(run('cmp', 'line.obj', 'module.obj')).toBe('');
});

test('imports the element where there is no DOM', () => {
  const element = run(
    'node',
    '--input-type=module',
    '-e',
    "const { WhittleView } = await import('whittle/element'); console.log(typeof WhittleView)",
  );
  expect(element.trim()).toBe('function');
});

test('has types', () => {
  writeFileSync(
    join(folder, 'use.ts'),
    `import { createEngine, type Mesh, type Outcome, readMesh, runRecipe } from 'whittle';
     import type { WhittleView } from 'whittle/element';
     export async function carve(bytes: Uint8Array): Promise<[Mesh, Outcome]> {
       const { mesh, steps } = await runRecipe(createEngine(), readMesh(bytes, 'a.obj'), {
         steps: [{ method: 'cubic', parameters: { lambda: 0.4 } }],
       });
       return [mesh, steps[0]!.outcome];
     }
     export function strength(view: WhittleView): number | null {
       return view.lambda;
     }
     // @ts-expect-error: a recipe has steps
     void runRecipe(createEngine(), readMesh(new Uint8Array(), 'a'), {});`,
  );
  for (const [module, resolution] of [
    ['NodeNext', 'NodeNext'],
    ['ESNext', 'Bundler'],
  ] as const) {
    const options = { module, moduleResolution: resolution, target: 'ES2022', strict: true, noEmit: true };
    const compilerOptions = { ...options, lib: ['ES2023', 'DOM', 'DOM.Iterable'], types: [] };
    writeFileSync(join(folder, 'tsconfig.json'), JSON.stringify({ compilerOptions, files: ['use.ts'] }));
    expect(run(join(root, 'node_modules/.bin/tsc'), '-p', '.')).toBe('');
  }
});
