import { describe, expect, test } from 'vitest';
import { textureOf } from '../../src/inputs/images/texture.ts';
import { textureSlopesOf } from '../../src/inputs/images/texture-slopes.ts';
import { readMesh } from '../../src/io/index.ts';
import { cross, dot, length, row, scale, subtract, unit, type Vec3 } from '../../src/mesh/vectors.ts';
import type { ParameterValues } from '../../src/methods/values/index.ts';
import { configure, prepare, testCore } from '../fixtures/core.ts';
import { normalMap, paint, plate, type TexturedMesh, texturedObj } from '../fixtures/textured.ts';

const regularizers = ['arap', 'farap', 'acap'] as const;

/** A run of `normalmap` to its end. */
async function raised(mesh: TexturedMesh, parameters: ParameterValues): Promise<Float64Array> {
  const session = (await testCore()).open();
  session.load(mesh.positions, mesh.triangles);
  configure(session, mesh, 'normalmap', parameters);
  prepare(session);
  while (session.step().outcome === 'running');
  const positions = new Float64Array(mesh.positions.length);
  session.copyPositions(positions);
  session.free();
  return positions;
}

/** Area-weighted vertex normals. */
function normalsOf(positions: Float64Array, triangles: Uint32Array): Vec3[] {
  const sums = new Float64Array(positions.length);
  for (let face = 0; face < triangles.length; face += 3) {
    const [a, b, c] = [0, 1, 2].map((k) => row(positions, triangles[face + k]!)) as [Vec3, Vec3, Vec3];
    const vector = cross(subtract(b, a), subtract(c, a));
    for (let k = 0; k < 3; k++)
      for (let axis = 0; axis < 3; axis++) sums[3 * triangles[face + k]! + axis]! += vector[axis]!;
  }
  return Array.from({ length: positions.length / 3 }, (_, v) => unit(row(sums, v)));
}

const degrees = (a: Vec3, b: Vec3): number => (Math.atan2(length(cross(a, b)), dot(a, b)) * 180) / Math.PI;

function meanAngle(a: readonly Vec3[], b: readonly Vec3[]): number {
  return a.reduce((sum, normal, i) => sum + degrees(normal, b[i]!), 0) / a.length;
}

describe('a plate with the normal map of known waves', () => {
  const mesh = plate(128);
  const waves = (amplitude: number) => (u: number, v: number) =>
    amplitude * Math.sin(6 * Math.PI * u) * Math.sin(6 * Math.PI * v);

  /** Which share of the waves is there, how far heights are off as a share of them, and how wide the plate is. */
  async function measured(amplitude: number, parameters: ParameterValues) {
    const image = textureSlopesOf(textureOf(normalMap(512, waves(amplitude)), 'waves'), mesh);
    const positions = await raised(mesh, { ...parameters, image });
    const count = positions.length / 3;
    const middle = positions.reduce((sum, x, i) => (i % 3 === 2 ? sum + x / count : sum), 0);
    let [shared, all, off, low, high] = [0, 0, 0, 1, 0];
    for (let p = 0; p < positions.length; p += 3) {
      const wanted = waves(amplitude)(mesh.positions[p]!, mesh.positions[p + 1]!);
      const height = positions[p + 2]! - middle;
      shared += height * wanted;
      all += wanted * wanted;
      off += (height - wanted) ** 2;
      [low, high] = [Math.min(low, positions[p]!), Math.max(high, positions[p]!)];
    }
    return { gain: shared / all, residual: Math.sqrt(off / all), extent: high - low };
  }

  test.each(regularizers)('%s brings 94 to 96 % of a height of 0.02 back', async (regularizer) => {
    const { gain, residual } = await measured(0.02, { regularizer });
    expect(gain).toBeGreaterThan(0.94);
    expect(gain).toBeLessThan(0.96);
    expect(residual).toBeLessThan(0.06);
  });

  test('a weak pull brings back less, and of steep waves the sheet’s lengths leave four fifths', async () => {
    expect((await measured(0.02, { regularizer: 'arap', lambda: 1 })).gain).toBeLessThan(0.92);
    const steep = await measured(0.05, { lambda: 40 });
    expect(steep.gain).toBeCloseTo(0.8, 1);
    expect(steep.extent).toBeCloseTo(0.93, 1);
  });

  test('what is bright above stands above: the top row of the picture is at v = 1', async () => {
    const bump = paint(128, (u, v) => {
      const white = Math.exp(-60 * ((u - 0.3) ** 2 + (v - 0.8) ** 2));
      return [white, white, white];
    });
    const small = plate(40);
    const positions = await raised(small, { image: textureSlopesOf(textureOf(bump, 'bump'), small) });
    let top = 2;
    for (let i = 2; i < positions.length; i += 3) if (positions[i]! > positions[top]!) top = i;
    expect(small.positions[top - 2]).toBeCloseTo(0.3, 1);
    expect(small.positions[top - 1]).toBeCloseTo(0.8, 1);
  });
});

describe('a ring, read from a file', () => {
  const side = 120;
  const turn = 2 * Math.PI;
  const place = (s: number, t: number): Vec3 => {
    const radius = 1 + 0.4 * Math.cos(turn * t);
    return [radius * Math.cos(turn * s), radius * Math.sin(turn * s), 0.4 * Math.sin(turn * t)];
  };

  /** The ring with its texture once round it and once round the tube; halves that are mirrored meet at both seams. */
  function ring(isMirrored: boolean): TexturedMesh {
    const at = (s: number): number => (isMirrored ? 1 - Math.abs(2 * s - 1) : s);
    const flat = plate(side + 1, (s, t) => place(s % 1, t % 1));
    const uvs = flat.uvs.map((x, i) => (i % 2 === 0 ? at(x) : x));
    const text = texturedObj({ ...flat, uvs });
    const { mesh } = readMesh(new TextEncoder().encode(text), 'ring.obj');
    return welded({ ...mesh, uvs: mesh.uvs! });
  }

  /** The plate's edges meet: one vertex each. */
  function welded(mesh: TexturedMesh): TexturedMesh {
    const inside = (p: number): number =>
      (Math.floor(p / (side + 1)) % side) * side + ((p % (side + 1)) % side);
    const positions = new Float64Array(3 * side * side);
    for (let p = 0; 3 * p < mesh.positions.length; p++) positions.set(row(mesh.positions, p), 3 * inside(p));
    return { ...mesh, positions, triangles: mesh.triangles.map(inside) };
  }

  /** Slopes of small waves along the ring, longer outside than inside, and around the tube: large ones would have to stretch it. */
  const slopes = (u: number, v: number): [number, number] => [
    (0.1 * Math.cos(6 * turn * u)) / (1 + 0.4 * Math.cos(turn * v)),
    0.1 * Math.sin(6 * turn * v),
  ];
  const map = paint(512, (u, v) => {
    const [x, y] = slopes(u, v);
    const size = Math.hypot(x, y, 1);
    return [0.5 - x / size / 2, 0.5 - y / size / 2, 0.5 + 0.5 / size];
  });

  /** Along the ring and the tube, where the frame is known; at the seams of mirrored halves what is along the ring cancels. */
  function wanted(isMirrored: boolean): Vec3[] {
    return Array.from({ length: side * side }, (_, vertex) => {
      const [s, t] = [(vertex % side) / side, Math.floor(vertex / side) / side];
      const along: Vec3 = [-Math.sin(turn * s), Math.cos(turn * s), 0];
      const tube = Math.sin(turn * t);
      const around: Vec3 = [-tube * Math.cos(turn * s), -tube * Math.sin(turn * s), Math.cos(turn * t)];
      const u = isMirrored ? 1 - Math.abs(2 * s - 1) : s;
      const [x, y] = slopes(u, t);
      const sign = !isMirrored ? 1 : s === 0 || s === 0.5 ? 0 : s < 0.5 ? 1 : -1;
      const normal = cross(along, around);
      return unit(subtract(subtract(normal, scale(along, sign * x)), scale(around, y)));
    });
  }

  test.each(regularizers)('%s: the normals of the shape are those of the map', async (regularizer) => {
    for (const isMirrored of [false, true]) {
      const mesh = ring(isMirrored);
      const image = textureSlopesOf(textureOf(map, 'map'), mesh);
      const targets = wanted(isMirrored);
      const before = meanAngle(normalsOf(mesh.positions, mesh.triangles), targets);
      const after = meanAngle(normalsOf(await raised(mesh, { image, regularizer }), mesh.triangles), targets);
      expect(before).toBeGreaterThan(5.5);
      expect(after).toBeLessThan(1);
    }
  });

  test('without strength, or from a flat map, every bit stays', async () => {
    const mesh = ring(true);
    const flat = textureOf(
      paint(8, () => [128 / 255, 127 / 255, 1]),
      'flat',
    );
    for (const regularizer of regularizers) {
      const still = { image: textureSlopesOf(textureOf(map, 'map'), mesh), strength: 0, regularizer };
      expect(await raised(mesh, still)).toEqual(mesh.positions);
      expect(await raised(mesh, { image: textureSlopesOf(flat, mesh), regularizer })).toEqual(mesh.positions);
    }
  });

  test('the same picture gives the same bits, and handles hold what they hold', async () => {
    const mesh = ring(false);
    const image = textureSlopesOf(textureOf(map, 'map'), mesh);
    const held = { vertices: [0, 5000], targets: [[1.5, 0, 0.1] as const, row(mesh.positions, 5000)] };
    const positions = await raised(mesh, { image, handles: held });
    expect(await raised(mesh, { image, handles: held })).toEqual(positions);
    held.vertices.forEach((vertex, h) => {
      expect(length(subtract(row(positions, vertex), held.targets[h]!))).toBeLessThan(1e-9);
    });
  });
});

test('a relief of another mesh is refused, and a mere name too', async () => {
  const session = (await testCore()).open();
  const mesh = plate(4);
  session.load(mesh.positions, mesh.triangles);
  const image = textureSlopesOf(
    textureOf(
      paint(4, () => [0.2, 0.5, 0.9]),
      'a',
    ),
    plate(5),
  );
  expect(() => configure(session, mesh, 'normalmap', { image })).toThrow(
    /each corner of the mesh’s 18 faces/,
  );
  session.configure('normalmap', new Map());
  expect(() => prepare(session)).toThrow(/normalmap needs an image/);
  session.free();
});
