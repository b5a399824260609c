import { describe, expect, it } from 'vitest';
import { normalsOfConvex } from '../../src/inputs/styles/convex-normals.ts';
import { jessen } from '../../src/inputs/styles/jessen.ts';
import { oloid } from '../../src/inputs/styles/oloid.ts';
import { findPrimitive } from '../../src/inputs/styles/primitives.ts';
import { refined } from '../../src/inputs/styles/refined.ts';
import { sphereNormals } from '../../src/inputs/styles/sphere-normals.ts';
import { capsule, findStyleMesh, styleMeshIds, tractricoid } from '../../src/inputs/styles/style-meshes.ts';
import { areaVectors, type Surface, volume } from '../../src/inputs/styles/surface.ts';
import { dot, length, row } from '../../src/mesh/vectors.ts';
import { configure, testCore } from '../fixtures/core.ts';
import { icosphere } from '../fixtures/meshes.ts';
import { cornerAngles, eulerCharacteristic, isClosedAndOriented } from '../fixtures/surfaces.ts';

async function flowed(surface: Surface, maxIterations = 300): Promise<Float64Array> {
  const session = (await testCore()).open();
  const { positions, triangles } = surface;
  session.load(positions, triangles);
  configure(session, surface, 'spherical', { maxIterations });
  session.prepare();
  while (session.step().outcome === 'running');
  const result = new Float64Array(positions.length);
  session.copyPositions(result);
  session.free();
  return result;
}

it('has its names for itself', () => {
  for (const id of styleMeshIds) expect(findPrimitive(id)).toBeUndefined();
  expect(findStyleMesh('cube')).toBeUndefined();
});

describe.each(styleMeshIds)('%s', (id) => {
  const { mesh } = findStyleMesh(id)!;

  it('is closed, outside out, of genus 0, with 2000 to 6000 vertices and no thin triangle', () => {
    expect(isClosedAndOriented(mesh)).toBe(true);
    expect(eulerCharacteristic(mesh)).toBe(2);
    expect(volume(mesh)).toBeGreaterThan(0);
    expect(mesh.positions.length / 3).toBeGreaterThanOrEqual(2000);
    expect(mesh.positions.length / 3).toBeLessThanOrEqual(6000);
    const angles = cornerAngles(mesh);
    expect(Math.min(...angles)).toBeGreaterThan(12);
    expect(Math.max(...angles)).toBeLessThan(135);
  });

  it('flows to the sphere, and its normals with it', async () => {
    const { points, triangles, vertexNormals, faceNormals } = sphereNormals(mesh, await flowed(mesh));
    expect(isClosedAndOriented({ positions: points, triangles })).toBe(true);
    expect(volume({ positions: points, triangles })).toBeGreaterThan(4);
    for (const [normals, count] of [
      [vertexNormals, points.length],
      [faceNormals, triangles.length],
      [points, points.length],
    ] as const) {
      expect(normals.length).toBe(count);
      for (let n = 0; 3 * n < count; n++) expect(length(row(normals, n))).toBeCloseTo(1, 9);
    }
    expect(meanCosine({ positions: points, triangles }, faceNormals)).toBeGreaterThan(0.5);
  });
});

/** How far the style's normals point the way of the sphere's, over the sphere: 1 for a sphere. */
function meanCosine(sphere: Surface, normals: Float64Array): number {
  const vectors = areaVectors(sphere);
  let sum = 0;
  let whole = 0;
  for (let face = 0; 3 * face < vectors.length; face++) {
    sum += dot(row(vectors, face), row(normals, face));
    whole += length(row(vectors, face));
  }
  return sum / whole;
}

describe('the shapes are what their names say', () => {
  it('oloid: its area is that of the unit sphere, its volume 3.0524', () => {
    const mesh = oloid(60);
    expect(volume(mesh)).toBeCloseTo(3.0524, 2);
    const vectors = areaVectors(mesh);
    let area = 0;
    for (let face = 0; 3 * face < vectors.length; face++) area += length(row(vectors, face)) / 2;
    expect(area).toBeCloseTo(4 * Math.PI, 2);
  });

  it('Jessen’s icosahedron: its volume is 20, and n parts of an edge make 10 n² + 2 vertices', () => {
    expect(volume(jessen(2))).toBeCloseTo(20, 6);
    expect(jessen(7).positions.length / 3).toBe(10 * 49 + 2);
  });

  it('capsule and tractricoid: volumes by formula', () => {
    expect(volume(capsule(0.03))).toBeCloseTo(Math.PI * (2 + 4 / 3), 1);
    expect(volume(tractricoid(0.02, 0.02))).toBeCloseTo((2 * Math.PI) / 3, 1);
  });
});

describe('refined for the flow', () => {
  it.each(['cube', 'tetrahedron', 'square-pyramid', 'hexagonal-prism'])(
    'a %s becomes a sphere',
    async (id) => {
      const { mesh, normals } = findPrimitive(id)!;
      const fine = refined(mesh);
      expect(fine.positions.length / 3).toBeGreaterThanOrEqual(2000);
      expect(isClosedAndOriented(fine)).toBe(true);
      expect(volume(fine)).toBeCloseTo(volume(mesh), 10);
      expect(normalsOfConvex(fine).length).toBe(normals.length);
      const { points, triangles } = sphereNormals(fine, await flowed(fine));
      expect(volume({ positions: points, triangles })).toBeGreaterThan(4);
    },
  );

  it('leaves a mesh of enough vertices as it is', () => {
    const { mesh } = findStyleMesh('oloid')!;
    expect(refined(mesh).triangles.length).toBe(mesh.triangles.length);
    expect(refined({ positions: new Float64Array(0), triangles: new Uint32Array(0) }).triangles.length).toBe(
      0,
    );
  });
});

describe('normals on the sphere', () => {
  it('of a sphere are its points', async () => {
    const sphere = icosphere(4);
    const { points, vertexNormals } = sphereNormals(sphere, await flowed(sphere));
    for (let p = 0; p < points.length; p++)
      expect(Math.abs(points[p]! - sphere.positions[p]!)).toBeLessThan(0.01);
    for (let p = 0; p < points.length; p++)
      expect(Math.abs(points[p]! - vertexNormals[p]!)).toBeLessThan(0.02);
  });

  it('do not care for units, place, seams or the side that is out', async () => {
    const mesh = jessen(8);
    const plain = sphereNormals(mesh, await flowed(mesh));
    const far = { positions: mesh.positions.map((x) => 30 * x + 7), triangles: mesh.triangles.toReversed() };
    const moved = sphereNormals(far, await flowed(far));
    for (let p = 0; p < plain.points.length; p++) {
      expect(moved.points[p]).toBeCloseTo(plain.points[p]!, 4);
      expect(moved.vertexNormals[p]).toBeCloseTo(plain.vertexNormals[p]!, 9);
    }

    const seamless = await flowed(mesh);
    const spread = (values: Float64Array): Float64Array<ArrayBuffer> =>
      Float64Array.from(Array.from(mesh.triangles).flatMap((v) => [...values.slice(3 * v, 3 * v + 3)]));
    const apart = { positions: spread(mesh.positions), triangles: Uint32Array.from(mesh.triangles.keys()) };
    const joined = sphereNormals(apart, spread(seamless));
    expect(joined.points.length).toBe(plain.points.length);
    expect(joined.faceNormals).toEqual(plain.faceNormals);
  });

  it('are refused while the flow is on its way', async () => {
    const mesh = jessen(8);
    const early = await flowed(mesh, 3);
    expect(() => sphereNormals(mesh, early)).toThrowError(/did not flow to a sphere: its radii differ by \d/);
  });
});
