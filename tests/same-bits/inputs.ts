import { mkdirSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { modelText, objText, offText, plyText, stlBytes } from '../fixtures/mesh-files.ts';
import { bunny, icosphere, type TestMesh } from '../fixtures/meshes.ts';
import { family, pipe, pretzel, sail, torus } from '../fixtures/shapes.ts';
import { bakedGlb, normalMap, paint, plate, pngOf, texturedObj } from '../fixtures/textured.ts';
import { pack3mf } from '../fixtures/tiny-files.ts';

const turn = 2 * Math.PI;
const waves = (u: number, v: number): number => 0.02 * Math.sin(3 * turn * u) * Math.cos(2 * turn * v);

/** Writes every file that a command line of this folder reads: meshes in each format, pictures, JSON values, recipes. */
export function writeInputs(folder: string): void {
  mkdirSync(folder, { recursive: true });
  const write = (name: string, content: string | Uint8Array): void =>
    writeFileSync(join(folder, name), content);
  for (const [name, content] of [...meshFiles(), ...pictures()]) write(name, content);
  for (const [name, value] of jsonFiles()) write(name, JSON.stringify(value));
}

function meshFiles(): [name: string, content: string | Uint8Array][] {
  const sheet = plate(40, (u, v) => [u, v, 0.3 * Math.sin(4 * u + v)]);
  const jar = plate(40, (u, v) => [Math.cos(turn * u * 0.9), Math.sin(turn * u * 0.9), 2 * v]);
  return [
    ['ball.obj', objText(icosphere(4))],
    ['family.obj', objText(family())],
    ['jar.obj', texturedObj(jar)],
    ['ellipsoid.obj', objText(scaled(icosphere(3), [1, 1, 2.5]))],
    ['bunny.off', offText(bunny())],
    ['pipe.off', offText(pipe(40, 40))],
    ['pretzel.ply', plyText(pretzel(3))],
    ['sail.stl', stlBytes(sail(40))],
    ['ring.stl', stlBytes(torus(48, 24))],
    ['egg.3mf', pack3mf({ '3D/3dmodel.model': modelText(scaled(icosphere(3), [1, 1, 2])) })],
    ['sheet.glb', bakedGlb(sheet, pngOf(normalMap(128, waves)))],
  ];
}

function pictures(): [name: string, content: Uint8Array][] {
  const grey = (u: number, v: number): readonly [number, number, number] => {
    const value = 0.5 + 20 * waves(u, v);
    return [value, value, value];
  };
  return [
    ['normals.png', pngOf(normalMap(128, waves))],
    ['heights.png', pngOf(paint(128, grey))],
  ];
}

function jsonFiles(): [name: string, value: unknown][] {
  const ball = icosphere(4);
  const vertices = [...Array(ball.positions.length / 3).keys()];
  const height = (v: number): number => ball.positions[3 * v + 2]!;
  const handles = bentEnds(ball);
  return [
    ['handles.json', handles],
    ['pins.json', { vertices: [0, 5, 700], targets: [[-0.6, 1, 0], [0.2, -0.9, 0.4], [2.6, 1.6, 0.5]] }], // biome-ignore format: pairs
    ['field.json', vertices.map((v) => 0.5 + 0.4 * height(v))],
    ['frames.json', [{ vertices: vertices.filter((v) => height(v) > 0.2), orientation: [0, 0, 0.38, 0.92] }]],
    ['matrix.json', [[1, 0, 0], [0.5, 0, 0.9], [0, 0.4, 0]]], // biome-ignore format: a matrix
    ['directions.json', [[1, 0, 0], [-1, 0, 0], [0, 1, 1], [0, -1, -1], [0, 1, -1], [0, -1, 1]]], // biome-ignore format: a list
    [
      'steps.json',
      recipe(
        { method: 'cubic', lambda: 0.3 },
        { method: 'analogy', style: 'octahedron', lambda: 0.5, regularizer: 'farap' },
        { method: 'developable', creases: 0.4, maxIterations: 30 },
        { method: 'arap', handles },
      ),
    ],
    [
      'relief.json',
      recipe(
        { method: 'normalmap', image: 'heights.png', strength: 0.8 },
        { method: 'polycube', directions: [[0, 0, 1], [0, 1, 0], [1, 0, 0]], maxIterations: 3 }, // biome-ignore format: a list
      ),
    ],
  ];
}

const recipe = (...steps: object[]): object => ({ whittle: 1, steps });

const scaled = ({ positions, triangles }: TestMesh, by: readonly number[]): TestMesh => ({
  positions: positions.map((x, i) => x * by[i % 3]!),
  triangles,
});

/** Holds the foot of a ball and turns its top by a quarter. */
function bentEnds({ positions }: TestMesh): { vertices: number[]; targets: number[][] } {
  const vertices = [...Array(positions.length / 3).keys()].filter(
    (v) => Math.abs(positions[3 * v + 1]!) > 0.9,
  );
  const targets = vertices.map((v) => {
    const [x, y, z] = positions.subarray(3 * v, 3 * v + 3) as unknown as [number, number, number];
    return y < 0 ? [x, y, z] : [z, y + 0.3, -x];
  });
  return { vertices, targets };
}
