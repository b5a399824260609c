import { describe, expect, test } from 'vitest';
import { row, type Vec3 } from '../../src/mesh/vectors.ts';
import { type Case, caseOf, meshed } from './cases.ts';
import { movedBy } from './gestures.ts';
import { shortfalls, wantedRatio } from './limits.ts';
import { Judge } from './measures.ts';
import type { Shape } from './shape.ts';

const meshes = new Map<string, Shape>();

/** What is said of a shape whose points went elsewhere while nothing was to move. */
function said(name: string, to: (at: Vec3) => Vec3, wanted = 1): string {
  const shape = meshes.get(name) ?? meshed(caseOf(name), 2);
  meshes.set(name, shape);
  const positions = shape.positions.slice();
  for (let v = 0; 3 * v < positions.length; v++) positions.set(to(row(positions, v)), 3 * v);
  return shortfalls(new Judge(shape).measure(positions, movedBy(shape, [0], [0, 0, 0])), wanted).join(', ');
}

describe('a person notices', () => {
  test('nothing where nothing is off', () => {
    expect(said('drilled plate', (at) => at)).toBe('');
    expect(said('chamfered box', (at) => at)).toBe('');
  });

  test.each<[string, string, (at: Vec3) => Vec3, RegExp]>([
    ['holes that grow by 3 %', 'drilled plate', ([x, y, z]) => [1.03 * x, 1.03 * y, z], /^hole \d ×1\.030/],
    ['stadiums', 'drilled plate', ([x, y, z]) => [1.02 * x, y / 1.02, z], /off round/],
    ['bevels that get wider', 'chamfered box', ([x, y, z]) => [x, 1.06 * y, 1.06 * z], /^bevel .* ×1\.060/],
    ['a side that tilts', 'drilled plate', ([x, y, z]) => [x, y, z + 0.002 * x * (z > 0 ? 1 : 0)], /tilts/],
    ['creases that bend', 'drilled plate', ([x, y, z]) => [x, y, z + 0.02 * x * x], /crease bends/],
    ['faces that turn over', 'drilled plate', ([x, y, z]) => [Math.abs(x - 2), y, z], /turned over/],
    ['normals that turn', 'drilled plate', ([x, y, z]) => [x, y, z + 0.3 * x], /normal turns/],
    ['handles that are left behind', 'drilled plate', ([x, y, z]) => [x + 0.05, y, z], /handle is off/],
    ['faces that are squeezed', 'drilled plate', ([x, y, z]) => [0.2 * x, y, z], /of their quality/],
  ])('%s', (_, name, to, words) => {
    expect(said(name, to)).toMatch(words);
  });

  test('a ball that was to grow and has not', () => {
    const made = caseOf('ball') satisfies Case;
    const wanted = wantedRatio(made, made.gestures.pull!);
    expect(wanted).toBe(1.5);
    expect(said('ball', (at) => at, wanted)).toMatch(/ball ×1\.000/);
    expect(said('ball', ([x, y, z]) => [1.5 * x, 1.5 * y, 1.5 * z], wanted)).not.toMatch(/ball/);
  });
});
