import { Quaternion } from 'three';
import { describe, expect, it } from 'vitest';
import { readPng } from '../../src/inputs/images/png.ts';
import { blankMap, mapOfPixels } from '../../src/inputs/styles/captures.ts';
import { lookup } from '../../src/inputs/styles/gauss-lookup.ts';
import { distance, dot, row, unit, type Vec3 } from '../../src/mesh/vectors.ts';
import { BrushSurface } from '../../src/viewer/brush-surface.ts';
import { inWords, nudged, pointed, toFile, toSeen } from '../../web/app/view-directions.ts';
import { NormalPainter } from '../../web/tools/paint-normals.ts';
import { headlessEditor, look, quiet } from '../fixtures/headless-editor.ts';

const ball = () => {
  const { points, triangles } = blankMap();
  return new BrushSurface(points, triangles);
};

describe('a surface to paint on', () => {
  it('reaches exactly the vertices in its ball', () => {
    const { points } = blankMap();
    const reached = new Set<number>();
    ball().around([0, 0, 1], 0.3, (vertex) => reached.add(vertex));
    const near = [...Array(points.length / 3).keys()].filter(
      (vertex) => distance(row(points, vertex), [0, 0, 1]) < 0.3,
    );
    expect([...reached].sort((a, b) => a - b)).toEqual(near);
  });

  it('finds what is pointed at', () => {
    const hit = ball().hit([0, 0.2, 5], [0, 0, -1])!;
    expect(hit.point[2]).toBeCloseTo(Math.sqrt(1 - 0.04), 2);
    expect(ball().hit([0, 3, 5], [0, 0, -1])).toBeNull();
  });
});

async function easel() {
  const { store, editor } = headlessEditor();
  await editor.open(Uint8Array.of(1), 'a.obj');
  const painter = new NormalPainter(store, editor, (run) => run());
  return { store, editor, painter, rest: () => quiet(store) };
}

describe('the painter', () => {
  const at = unit([0.5, 0.2, 0.8]);

  it('paints a ball of its own for each step', async () => {
    const { editor, painter, rest } = await easel();
    const stroke = async () => {
      painter.begin(at);
      painter.end();
      await rest();
    };
    await stroke();
    await editor.addStep('analogy', { style: 'octahedron' });
    await rest();
    const [first] = editor.project!.steps;
    painter.setBrush({ direction: [1, 0, 0] });
    await stroke();
    await stroke();
    expect(editor.project!.steps[0]).toBe(first);
    expect(editor.project!.steps.map(({ parameters }) => parameters.style)).toEqual([
      'painted.png',
      'painted-2.png',
    ]);
    expect(painter.name).toBe('painted-2.png');
  });

  it('paints its direction where it touches and nowhere else, mirrored to the back', async () => {
    const { painter, rest } = await easel();
    painter.setBrush({ direction: unit([0, 1, 1]), size: 20, hardness: 1, mirror: true });
    painter.begin(at);
    painter.end();
    await rest();
    const target = lookup(painter.map);
    expect(dot(target(at), unit([0, 1, 1]))).toBeCloseTo(1, 9);
    expect(dot(target([at[0], at[1], -at[2]]), unit([0, 1, -1]))).toBeCloseTo(1, 9);
    expect(dot(target([-1, 0, 0]), [-1, 0, 0])).toBeCloseTo(1, 9);
  });

  it('makes one entry of a stroke; undo takes it off the ball', async () => {
    const { painter, editor, store, rest } = await easel();
    const before = painter.map;
    painter.begin(at);
    painter.move(unit([0.4, 0.4, 0.8]));
    painter.move(unit([0.1, 0.5, 0.8]));
    expect(painter.map).not.toBe(before);
    painter.end();
    await rest();
    expect(store.state.history.past.map(({ label }) => label)).toEqual(['Stroke']);
    expect(look(editor.project)).toMatchObject({
      method: 'analogy',
      parameters: { style: 'painted.png' },
    });
    editor.undo();
    expect(painter.map.normals).toEqual(before.normals);
    editor.redo();
    painter.clear();
    await rest();
    expect(painter.map.normals).toEqual(blankMap().normals);
  });

  it('erases what was painted, and picks a direction from the ball', async () => {
    const { painter, store, rest } = await easel();
    const direction = unit([0, 1, 1]);
    painter.setBrush({ direction, size: 30, hardness: 1, mirror: false });
    painter.begin(at);
    painter.end();
    await rest();
    painter.setBrush({ mode: 'pick', direction: [1, 0, 0] });
    painter.begin(at);
    painter.end();
    expect(painter.brush.mode).toBe('paint');
    expect(dot(painter.brush.direction, direction)).toBeCloseTo(1, 6);
    painter.setBrush({ mode: 'erase', size: 40 });
    painter.begin(at);
    painter.end();
    await rest();
    expect(store.state.history.past.map(({ label }) => label)).toEqual(['Stroke', 'Erase']);
    expect(painter.map.normals.every((value, k) => Math.abs(value - painter.map.points[k]!) < 1e-9)).toBe(
      true,
    );
  });

  it('saves what it loads again', async () => {
    const { painter, rest } = await easel();
    painter.setBrush({ direction: [1, 0, 0], size: 40, hardness: 0 });
    painter.begin(at);
    painter.end();
    await rest();
    const read = mapOfPixels(readPng(painter.capture(), 'painted.png'));
    const [saved, painted] = [lookup(read), lookup(painter.map)];
    for (const point of [at, unit([0.2, 0.2, 0.9]), unit([0.5, 0.2, -0.8])])
      expect(dot(saved(point), painted(point))).toBeGreaterThan(0.999);
  });
});

describe('directions', () => {
  const view = {
    orientation: new Quaternion().setFromAxisAngle({ x: 0, y: 1, z: 0 } as never, 0.7),
    zUp: true,
  };

  it('go to the eye and back', () => {
    const direction = unit([0.3, -0.5, 0.7]);
    expect(dot(toFile(toSeen(direction, view), view), direction)).toBeCloseTo(1, 12);
    const up = toSeen([0, 0, 1], view);
    expect(up[1]).toBeCloseTo(1);
  });

  it('are pointed at in front and, beyond the rim, behind', () => {
    expect(pointed(0, 0)).toEqual([0, 0, 1]);
    expect(pointed(0.6, 0)[2]).toBeCloseTo(0.8);
    expect(pointed(1.5, 0)[2]).toBeLessThan(-0.5);
    expect(pointed(9, 0)[2]).toBeCloseTo(-1);
    const right: Vec3 = nudged([0, 0, 1], 0.5, 0);
    expect(right[0]).toBeGreaterThan(0.4);
    expect(inWords(right)).toBe('right, towards you');
  });
});
