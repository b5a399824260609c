import { mkdtempSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { describe, expect, test } from 'vitest';
import { objText } from '../../fixtures/mesh-files.ts';
import { asDrawn, caseOf } from '../cases.ts';
import { stretched } from '../gestures.ts';
import { oblique, type Shape, turned } from '../shape.ts';
import { SurfaceFacts } from '../surface-facts.ts';
import { wallsOf } from '../walls.ts';
import { Asked } from './asked.ts';
import { foundGestures } from './found-gestures.ts';
import { foundShape } from './found-shape.ts';
import { foundTrials } from './found-trials.ts';
import { keptRound } from './leaning.ts';

const made = (name: string): Shape => asDrawn(caseOf(name));

/** The shape of files, of which nothing is known but faces. */
function found(...shapes: readonly Shape[]): Shape {
  const folder = mkdtempSync(join(tmpdir(), 'whittle-found-'));
  for (const shape of shapes) writeFileSync(join(folder, `${shape.name}.obj`), objText(shape));
  const files = shapes.map(({ name }, k) => ({ path: `${name}.obj`, at: [10 * k, 0, 0] as const }));
  return foundShape(folder, { name: 'it', files });
}

const kinds = ({ rounds }: Shape): string[] => rounds.map(({ name }) => name.replace(/ \d+$/, ''));
const sorted = (vertices: readonly number[]): number[] => vertices.toSorted((a, b) => a - b);

describe('of a mesh file are found', () => {
  test('the holes of a plate, by the very vertices that it was drilled with', () => {
    const plate = made('drilled plate');
    const { rounds } = found(plate);
    const named = plate.rounds.map(({ vertices }) => sorted(vertices));
    expect(rounds).toHaveLength(named.length);
    for (const { name, vertices } of rounds) {
      expect(name).toMatch(/^hole/);
      expect(named).toContainEqual(sorted(vertices));
    }
  });

  test('pegs, the fillet of a bracket, and no cylinder where edges are sharp or bevelled', () => {
    expect(kinds(found(made('pegs on a board')))).toEqual(made('pegs on a board').rounds.map(() => 'rod'));
    expect(kinds(found(made('bracket'))).toSorted()).toEqual(['hole', 'hollow']);
    expect(kinds(found(made('chair')))).toEqual([]);
    expect(kinds(found(made('chamfered box')))).toEqual([]);
  });

  test('bevels, and none where sides are square or round', () => {
    expect(found(made('chamfered box')).bevels).toHaveLength(12);
    expect(found(made('chair')).bevels).toEqual([]);
    expect(found(made('rounded box')).bevels).toEqual([]);
  });

  test('the cylinders of several files that are one thing, each where it belongs', () => {
    const both = found(made('drilled plate'), made('nut'));
    expect(kinds(both)).toHaveLength(made('drilled plate').rounds.length + 1);
    expect(Math.max(...both.positions)).toBeGreaterThan(10);
  });
});

describe('a gesture is asked', () => {
  const nut = made('nut');
  const gesture = { held: 'front', moved: 'back', factor: 1.4 };

  test('for all that it does not pull apart itself', () => {
    const asked = new Asked(nut, stretched(nut, gesture));
    expect(asked.rounds()).toEqual(nut.rounds);
  });

  test('not for a cylinder whose sides it takes apart, nor for the bore within it', () => {
    const ring = found(made('rod of 12 sides'));
    const [rod] = ring.rounds;
    expect(rod!.name).toBe('rod 1');
    const bore = { ...rod!, name: 'bore' };
    const both = { ...ring, rounds: [rod!, bore] };
    const apart = stretched(both, { held: 'x low', moved: 'x high', factor: 1.4 });
    expect(new Asked(both, apart).rounds()).toEqual([]);
    const along = stretched(both, { held: 'z low', moved: 'z high', factor: 1.4 });
    expect(new Asked(both, along).rounds()).toEqual([rod, bore]);
  });

  test('not for the thickness of a plate that is raised', () => {
    const plate = made('drilled plate');
    const facts = new SurfaceFacts(plate);
    const walls = wallsOf(facts);
    const isFlat = (face: number) => Math.abs(facts.normals[face]![2]) > 0.5;
    const of = (name: string) => new Asked(plate, stretched(plate, caseOf('drilled plate').gestures[name]!));
    for (const wall of walls) {
      expect(of('raise').isWallAsked(wall)).toBe(!isFlat(wall.face));
      expect(of('lengthen').isWallAsked(wall)).toBe(true);
    }
  });
});

test('a cylinder that comes to lean is as thick and as round as it was, one that is squeezed is not', () => {
  const rod = found(made('rod of 12 sides'));
  const [round] = rod.rounds;
  const lean = turned(rod, oblique).positions;
  const kept = keptRound(rod, round!, lean);
  expect(kept.ratio).toBeCloseTo(1, 9);
  expect(kept.roundness).toBeLessThan(1e-9);
  const squeezed = rod.positions.map((x, i) => (i % 3 === 0 ? 0.8 * x : x));
  expect(keptRound(rod, round!, squeezed).roundness).toBeGreaterThan(0.05);
});

test('its longest side is lengthened, the next widened, the last raised; what it comes to is measured', async () => {
  const shape = found(made('drilled plate'));
  const gestures = foundGestures(shape);
  expect(Object.entries(gestures).map(([name, { held }]) => `${name}: ${held}`)).toEqual([
    'lengthen: x low',
    'widen: y low',
    'raise: z low',
  ]);
  const [trial] = await foundTrials(shape, { lengthen: gestures.lengthen! }, { tuned: {} });
  const { result } = trial!;
  if (typeof result === 'string') throw new Error(result);
  expect(result.rounds).toHaveLength(shape.rounds.length);
  for (const { ratio } of result.rounds) expect(Math.abs(ratio - 1)).toBeLessThan(0.02);
});
