import { describe, expect, it } from 'vitest';
import { edgesOf } from '../../src/mesh/edges.ts';
import { extentOf } from '../../src/mesh/extent.ts';
import type { Mesh } from '../../src/mesh/mesh.ts';
import { Morph } from '../../src/viewer/morph.ts';
import { Pace } from '../../src/viewer/pace.ts';
import { RenderLoop } from '../../src/viewer/render-loop.ts';
import { Surface } from '../../src/viewer/surface.ts';
import { frameOf } from '../../src/viewer/view-frame.ts';
import { tetrahedron } from '../fixtures/fake-engine.ts';
import { pipe, sail } from '../fixtures/shapes.ts';
import { tenMeshes } from '../fixtures/ten-meshes.ts';

/** Two triangles side by side whose common edge is stored twice, far from the origin. */
function seamed(): Mesh {
  const corners = [0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 1, 1];
  const positions = new Float64Array(18);
  for (let v = 0; v < 6; v++) positions.set([1e6 + corners[2 * v]!, 1e6 + corners[2 * v + 1]!, 5], 3 * v);
  return { positions, triangles: Uint32Array.of(0, 1, 2, 3, 5, 4) };
}

describe('a surface', () => {
  it('writes every iteration into the buffers it has', () => {
    const surface = new Surface(tetrahedron());
    const buffers = () =>
      ['position', 'normal'].map((name) => surface.geometry.getAttribute(name).array as Float32Array);
    const [before, index] = [buffers(), surface.geometry.index];
    const [positions] = before.map((array) => array.slice());
    surface.write(tetrahedron().positions.map((x) => 2 * x));
    buffers().forEach((array, k) => {
      expect(array).toBe(before[k]);
    });
    expect(surface.geometry.index).toBe(index);
    expect(buffers()[0]).not.toEqual(positions);
    expect(Math.max(...before[0]!)).toBeGreaterThan(1);
  });

  it('keeps its precision far from the origin and joins seams in its normals', () => {
    const surface = new Surface(seamed());
    expect(surface.drawn[3]! - surface.drawn[0]!).toBeCloseTo(Math.SQRT2, 6);
    const normals = [...surface.geometry.getAttribute('normal').array];
    expect(normals).toEqual(Array.from({ length: 6 }, () => [0, 0, 1]).flat());
  });

  it('is framed by what matters: strays move neither the frame nor the floor', () => {
    const plain = new Surface(tetrahedron());
    const { positions, triangles } = tetrahedron();
    const strays = [1e6, -1e6, 3, Number.NaN, 0, Number.POSITIVE_INFINITY];
    const speck = [1e5, -1e5, 0, 1e5 + 1e-3, -1e5, 0, 1e5, -1e5, 1e-3];
    const surface = new Surface({
      positions: Float64Array.of(...positions, ...strays, ...speck),
      triangles: Uint32Array.of(...triangles, 6, 7, 8),
    });
    expect([surface.frame, surface.size]).toEqual([plain.frame, plain.size]);
    expect([surface.reach, surface.lowest(1)]).toEqual([plain.reach, plain.lowest(1)]);
  });

  it('shows two-sided faces once, and lights them', () => {
    const { positions, triangles } = tetrahedron();
    const back = triangles.slice().reverse();
    const surface = new Surface({ positions, triangles: Uint32Array.of(...triangles, ...back) });
    const plain = new Surface(tetrahedron());
    expect(surface.geometry.index!.array).toEqual(triangles);
    expect(surface.geometry.getAttribute('normal').array).toEqual(
      plain.geometry.getAttribute('normal').array,
    );
    expect(surface.facing).toBe('out');
  });

  it('knows where its faces look, and that a sheet has no inside', () => {
    const turned = ({ positions, triangles }: Pick<Mesh, 'positions' | 'triangles'>): Mesh => ({
      positions,
      triangles: triangles.slice().reverse() as Mesh['triangles'],
    });
    expect(new Surface(tetrahedron()).facing).toBe('out');
    expect(new Surface(turned(tetrahedron())).facing).toBe('in');
    expect(new Surface(pipe(20, 30) as Mesh).facing).toBe('in');
    expect(new Surface(turned(pipe(20, 30))).facing).toBe('out');
    expect(new Surface(sail(12) as Mesh).facing).toBe('neither');
    expect(new Surface(turned(sail(12))).facing).toBe('neither');
  });

  it('of every sample looks outwards', async () => {
    for (const { name, about, mesh } of await tenMeshes())
      if (about.startsWith('sample')) expect([name, new Surface(mesh as Mesh).facing]).toEqual([name, 'out']);
  });
});

describe('edges', () => {
  it('are there once each, borders and seams included', () => {
    const mesh = tetrahedron();
    const closed = edgesOf(mesh.triangles, mesh.triangles, 4);
    expect(closed.ends).toHaveLength(12);
    expect([...closed.faces]).toEqual([2, 2, 2, 2, 2, 2]);
    const seam = edgesOf(Uint32Array.of(0, 1, 2, 1, 3, 2), Uint32Array.of(0, 1, 2, 3, 5, 4), 4);
    expect([...seam.ends]).toEqual([0, 1, 1, 2, 2, 0, 3, 5, 5, 4]);
    expect([...seam.faces]).toEqual([1, 2, 1, 1, 1]);
  });
});

describe('a glide', () => {
  it('begins where it was and ends exactly at its goal', () => {
    const drawn = Float32Array.of(0, 0, 0);
    const morph = new Morph(drawn, Float32Array.of(1, 2, 3), 100, 200);
    expect(morph.write(100, drawn)).toBe(true);
    expect([...drawn]).toEqual([0, 0, 0]);
    expect(morph.write(200, drawn)).toBe(true);
    expect(drawn[2]).toBeCloseTo(1.5);
    expect(morph.write(300, drawn)).toBe(false);
    expect([...drawn]).toEqual([1, 2, 3]);
  });
});

describe('drawing on demand', () => {
  it('asks once for many changes, and not at all at rest or without a context', () => {
    const asked: ((now: number) => void)[] = [];
    let drawings = 0;
    const loop = new RenderLoop(
      () => drawings++,
      (callback) => asked.push(callback),
      () => {},
    );
    loop.invalidate();
    loop.invalidate();
    expect(asked).toHaveLength(1);
    asked[0]!(0);
    expect([drawings, asked.length]).toEqual([1, 1]);
    loop.pause();
    loop.invalidate();
    expect(asked).toHaveLength(1);
    loop.resume();
    expect(asked).toHaveLength(2);
  });
});

describe('the pace of drawing', () => {
  it('stays sharp on a quick machine and gives way on a slow one', () => {
    const quick = new Pace();
    for (let frame = 0; frame < 50; frame++) expect(quick.moving(16 * frame)).toBe(1);
    const slow = new Pace();
    for (let frame = 0; frame < 50; frame++) slow.moving(90 * frame);
    expect(slow.moving(90 * 50)).toBe(0.5);
    expect(slow.isReduced).toBe(true);
  });

  it('does not take rest for slowness', () => {
    const pace = new Pace();
    for (let frame = 0; frame < 20; frame++) expect(pace.moving(1000 * frame)).toBe(1);
  });
});

it('a mesh of one point has a frame all the same', () => {
  expect(frameOf(extentOf(Float64Array.of(2, 3, 4), Uint32Array.of(0, 0, 0)))).toEqual({
    center: [2, 3, 4],
    scale: 1,
  });
});
