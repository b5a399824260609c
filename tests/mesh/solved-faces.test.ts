import { describe, expect, test } from 'vitest';
import { solvedFacesOf } from '../../src/mesh/solved-faces.ts';
import { solvedSourceTriangles, weldOf } from '../../src/mesh/weld.ts';
import { textureSlopes } from '../../src/methods/values/texture-slopes.ts';
import { icosphere, type TestMesh, together } from '../fixtures/meshes.ts';

const ball = icosphere(2);
const faces = ball.triangles.length / 3;

const solve = ({ positions, triangles }: TestMesh) => solvedFacesOf(positions, triangles);
const face = (triangles: Uint32Array, f: number): number[] => [...triangles.subarray(3 * f, 3 * f + 3)];
const reversed = (triangles: Uint32Array): number[] =>
  Array.from({ length: triangles.length / 3 }, (_, f) => face(triangles, f).reverse()).flat();
const withFaces = (...more: number[][]): TestMesh => ({
  ...ball,
  triangles: Uint32Array.from([...ball.triangles, ...more.flat()]),
});
const turned = (isTurned: (f: number) => boolean, { positions, triangles }: TestMesh = ball): TestMesh => ({
  positions,
  triangles: Uint32Array.from(
    Array.from({ length: triangles.length / 3 }, (_, f) =>
      isTurned(f) ? face(triangles, f).reverse() : face(triangles, f),
    ).flat(),
  ),
});
const halfEdges = (triangles: Uint32Array): Set<string> =>
  new Set(Array.from(triangles, (v, c) => `${v} ${triangles[c % 3 === 2 ? c - 2 : c + 1]}`));

describe('good faces stay as they are', () => {
  test.each([
    ['a ball', ball],
    ['a ball inside out', turned(() => true)],
    [
      'a ball in a ball inside out',
      together({ mesh: ball, offset: [0, 0, 0] }, { mesh: turned(() => true), offset: [3, 0, 0] }),
    ],
    ['an open surface', { ...ball, triangles: ball.triangles.slice(0, 300) }],
  ])('%s', (_, mesh) => {
    expect(solve(mesh)).toBeUndefined();
  });

  test('damaged ones too: the core names them', () => {
    expect(
      solve({ ...ball, triangles: Uint32Array.from([...ball.triangles, 0, 1, 9999, 5, 5, 6]) }),
    ).toBeUndefined();
  });
});

describe('faces that repeat others count once', () => {
  test.each([
    ['two-sided', withFaces(reversed(ball.triangles)), faces],
    ['two-sided in part', withFaces(reversed(ball.triangles.subarray(0, 99))), 33],
    ['three times', withFaces([...ball.triangles], reversed(ball.triangles)), 2 * faces],
    ['a region twice', withFaces([...ball.triangles.subarray(30, 60)]), 10],
  ])('%s', (_, mesh, repeated) => {
    const solved = solve(mesh)!;
    expect(solved.triangles).toEqual(ball.triangles);
    expect([solved.repeated, solved.turned]).toEqual([repeated, 0]);
    solved.solvedOf.forEach((s, f) => {
      expect(new Set(face(solved.triangles, s))).toEqual(new Set(face(mesh.triangles, f)));
    });
  });
});

describe('neighbours look the same way', () => {
  test.each([
    ['a few are turned', (f: number) => f % 7 === 0],
    ['most are turned of a closed part, and it looks outward', (f: number) => f % 8 < 5],
  ])('%s', (_, isTurned) => {
    const solved = solve(turned(isTurned))!;
    expect(halfEdges(solved.triangles)).toEqual(halfEdges(ball.triangles));
    expect(solved.turned).toBe(Array.from({ length: faces }, (_, f) => isTurned(f)).filter(Boolean).length);
  });

  test('a part inside out stays so with a few of its faces mended', () => {
    const solved = solve(turned((f) => f % 9 !== 0))!;
    expect(halfEdges(solved.triangles)).toEqual(halfEdges(turned(() => true).triangles));
  });

  test('two-sided and in disorder at once', () => {
    const solved = solve({
      ...ball,
      triangles: turned((f) => f % 3 === 0, withFaces(reversed(ball.triangles))).triangles,
    })!;
    expect(halfEdges(solved.triangles)).toEqual(halfEdges(ball.triangles));
    expect(solved.repeated).toBe(faces);
  });

  test('each part for itself', () => {
    const two = together(
      { mesh: turned((f) => f === 4), offset: [0, 0, 0] },
      { mesh: turned((f) => f !== 4), offset: [3, 0, 0] },
    );
    const solved = solve(two)!;
    expect(solved.turned).toBe(2);
  });

  test('a strip with one side says so', () => {
    const steps = 20;
    const positions = Float64Array.from(
      Array.from({ length: steps }, (_, i) => {
        const [a, b] = [(2 * Math.PI * i) / steps, (Math.PI * i) / steps];
        return [-0.2, 0.2].flatMap((w) => [
          (1 + w * Math.cos(b)) * Math.cos(a),
          (1 + w * Math.cos(b)) * Math.sin(a),
          w * Math.sin(b),
        ]);
      }).flat(),
    );
    const strip = Array.from({ length: steps }, (_, i) => {
      const [a, b] = [2 * i, 2 * i + 1];
      const [c, d] = i + 1 < steps ? [a + 2, b + 2] : [1, 0];
      return [a, b, c, b, d, c];
    }).flat();
    const solved = solve({ positions, triangles: Uint32Array.from(strip) })!;
    expect([solved.oneSidedEdges, solved.turned, solved.repeated]).toEqual([1, 0, 0]);
  });
});

test('what belongs to corners follows them', () => {
  const mesh = turned((f) => f === 5, withFaces(reversed(ball.triangles.subarray(0, 30))));
  const weld = weldOf(mesh);
  const uvs = Float32Array.from(Array.from(mesh.triangles, (v) => [v, -v]).flat());
  const descriptor = {
    name: 'image',
    kind: 'textureSlopes',
    label: '',
    doc: '',
    invalidates: 'weights',
  } as const;
  const { numbers } = textureSlopes.encode(descriptor, { uvs, slopes: uvs }, weld);
  const { triangles } = weld.solved!;
  expect(numbers).toHaveLength(4 * triangles.length);
  expect(Array.from(triangles, (_, c) => numbers[2 * c])).toEqual(Array.from(triangles));
  expect(solvedSourceTriangles(mesh)).toEqual(triangles);
});
