import { describe, expect, test } from 'vitest';
import { row, type Vec3 } from '../../src/mesh/vectors.ts';
import type { Handles } from '../../src/methods/values/handles.ts';
import { asDrawn, caseOf, meshed } from './cases.ts';
import { collapsed } from './collapses.ts';
import { movedBy, stretched, together } from './gestures.ts';
import { shortfalls } from './limits.ts';
import { Judge } from './measures.ts';
import { part, type Shape } from './shape.ts';
import { refusal, reshaped } from './solved.ts';

const plate = meshed(caseOf('drilled plate'), 2);
const hold = movedBy(plate, part(plate, 'left'), [0, 0, 0]);
const pull = movedBy(plate, part(plate, 'right'), [1.5, 0, 0]);
const [a, b] = part(plate, 'right') as [number, number];

describe('what is made shorter by 80 %', () => {
  test.each([
    'drilled plate',
    'chamfered box',
    'angle',
    'pegs on a board',
    'cylinder',
    'mug',
    'table',
    'bracket',
    'rounded box',
    'nut',
    'chair',
    'pin in a hole',
  ])('%s: nothing turns over', async (name) => {
    expect(await collapsed(caseOf(name), meshed(caseOf(name), 2))).toBe('nothing turns over');
  });

  test.each(['chamfered box', 'rounded box', 'cylinder', 'chair'])(
    '%s, with the slivers of a program for construction: nothing turns over',
    async (name) => {
      expect(await collapsed(caseOf(name), asDrawn(caseOf(name)))).toBe('nothing turns over');
    },
  );

  test('bottle, whose rings would have to pass through each other: refused', async () => {
    expect(await collapsed(caseOf('bottle'), meshed(caseOf('bottle'), 2))).toBe('refused');
  });
});

describe('handles that go oddly', () => {
  test('ends that pass through each other are refused, and it says why', async () => {
    const through = together(hold, movedBy(plate, part(plate, 'right'), [-5, 0, 0]));
    const { message, code } = (await refusal(plate, through))!;
    expect(code).toBe('bad-handles');
    expect(message).toMatch(/inside out: \d+ of its 954 faces fold over/);
  });

  test('a vertex that is to be in two places is refused, and it says which', async () => {
    const twice: Handles = {
      vertices: [a, a],
      targets: [
        [5, 0, 0],
        [4, 1, 0],
      ],
    };
    const { message, code } = (await refusal(plate, together(hold, twice)))!;
    expect(code).toBe('bad-handles');
    expect(message).toContain(`vertex ${a} two different targets`);
  });

  test('neighbours that change places give a compromise that says what folds', async () => {
    const swapped: Handles = {
      vertices: [a, b],
      targets: [row(plate.positions, b), row(plate.positions, a)],
    };
    const handles = together(hold, swapped);
    const { positions, warnings } = await reshaped(plate, handles);
    const { flipped, handle } = new Judge(plate).measure(positions, handles);
    expect(flipped).toBeLessThan(5);
    expect(handle).toBeLessThan(0.005);
    expect(warnings.join()).toContain(`Of the faces ${flipped} fold over`);
  });

  test('an end that is torn in two gives a compromise that says by how much handles are missed', async () => {
    const torn = part(plate, 'right').map((v): Vec3 => {
      const [x, y, z] = row(plate.positions, v);
      return [x + (y > 1 ? 0.6 : -0.6), y, z];
    });
    const handles = together(hold, { vertices: part(plate, 'right'), targets: torn });
    const { positions, warnings } = await reshaped(plate, handles);
    const { handle } = new Judge(plate).measure(positions, handles);
    expect(handle).toBeLessThan(0.02);
    expect(warnings.join()).toContain(`A handle is missed by ${(100 * handle).toFixed(1)} % of the diagonal`);
  });

  test('one handle moves all of it, as it is', async () => {
    const way = [0.3, 0.2, 0.1] as const;
    const { positions } = await reshaped(plate, movedBy(plate, [a], [...way]));
    for (const [p, value] of positions.entries())
      expect(Math.abs(value - plate.positions[p]! - way[p % 3]!)).toBeLessThan(1e-9);
  });

  test('no handle moves nothing, and it says so', async () => {
    const { positions, warnings } = await reshaped(plate, { vertices: [], targets: [] });
    expect(positions).toEqual(plate.positions);
    expect(warnings.join()).toContain('Nothing is held');
  });

  test('where all vertices are handles they go where they are to go', async () => {
    const all = Array.from({ length: plate.positions.length / 3 }, (_, v) => v);
    const targets = all.map((v): Vec3 => {
      const [x, y, z] = row(plate.positions, v);
      return [1.2 * x, y, z];
    });
    const { positions } = await reshaped(plate, { vertices: all, targets });
    expect(new Judge(plate).measure(positions, { vertices: all, targets }).handle).toBeLessThan(0.002);
  });

  test.each(['together', 'free'])(
    'with handles on one part only the other goes along, as it is (%s)',
    async (parts) => {
      const shape = meshed(caseOf('pin in a hole'), 2);
      const handles = stretched(shape, caseOf('pin in a hole').gestures.lengthen!);
      const { positions } = await reshaped(shape, handles, { parts });
      for (const v of part(shape, 'pin top'))
        expect(row(positions, v)[0]).toBeGreaterThan(row(shape.positions, v)[0] + 0.5);
      expect(shortfalls(new Judge(shape).measure(positions, handles))).toEqual([]);
    },
  );
});

describe('a plate', () => {
  test.each<[string, (shape: Shape) => Shape]>([
    ['that is open', (shape) => ({ ...shape, triangles: shape.triangles.slice(60) })],
    ['with a fin on an edge', withFin],
    [
      'with faces twice',
      (shape) => ({ ...shape, triangles: joined(shape.triangles, shape.triangles.subarray(0, 90)) }),
    ],
    [
      'with faces that have no area',
      (shape) => ({ ...shape, triangles: joined(shape.triangles, [0, 0, 1, 2, 1, 1]) }),
    ],
  ])('%s is lengthened all the same', async (_, spoilt) => {
    const handles = together(hold, pull);
    const shape = spoilt(plate);
    const { positions } = await reshaped(shape, handles);
    // The faces of the plate that are still there.
    const triangles = shape.triangles.slice(0, plate.triangles.length);
    const { handle, planeTilt, flipped, rounds } = new Judge({ ...plate, triangles }).measure(
      positions.slice(0, plate.positions.length),
      handles,
    );
    expect(handle).toBeLessThan(0.005);
    expect(planeTilt).toBeLessThan(0.1);
    expect(flipped).toBe(0);
    for (const { name, ratio } of rounds) expect(Math.abs(ratio - 1), name).toBeLessThan(0.03);
  });
});

/** One more face on a sharp edge. */
function withFin(shape: Shape): Shape {
  const [v, w] = [shape.triangles[0]!, shape.triangles[1]!];
  const [p, q] = [row(shape.positions, v), row(shape.positions, w)];
  const tip = [(p[0] + q[0]) / 2, (p[1] + q[1]) / 2, p[2] + 0.3];
  return {
    ...shape,
    positions: Float64Array.from([...shape.positions, ...tip]),
    triangles: joined(shape.triangles, [v, w, shape.positions.length / 3]),
  };
}

function joined(first: Uint32Array, then: ArrayLike<number>): Uint32Array<ArrayBuffer> {
  return Uint32Array.from([...first, ...Array.from(then)]);
}
