import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { readMesh } from '../../../src/io/index.ts';
import { row, type Vec3 } from '../../../src/mesh/vectors.ts';
import { gather, solvedTriangles, weldOf } from '../../../src/mesh/weld.ts';
import type { Stretching } from '../gestures.ts';
import { assembled, type Shape } from '../shape.ts';
import { SurfaceFacts } from '../surface-facts.ts';
import { bevelsOf } from './bevels.ts';
import { roundsOf } from './rounds.ts';

/** Something that people made, in a list that is kept as JSON. */
export interface Thing {
  readonly name: string;
  /** Mesh files that are its parts: their paths in a folder, with where their origin is in the thing if it is not at its own. */
  readonly files: readonly (string | { readonly path: string; readonly at: Vec3 })[];
  /** What is done with it; else its box is made longer in each direction. Ends are called `x low` to `z high`. */
  readonly gestures?: Readonly<Record<string, Stretching>>;
}

/** The ends of a side of the box: vertices that are within a hundredth of its length. */
const near = 0.01;

/** A thing from its files, its ends, cylinders and bevels found by what they look like. */
export function foundShape(folder: string, { name, files }: Thing): Shape {
  const parts = files.map((file) => {
    const { path, at } = typeof file === 'string' ? { path: file, at: [0, 0, 0] as const } : file;
    return [path, partOf(join(folder, path), at)] as const;
  });
  const whole = parts.length === 1 ? parts[0]![1] : assembled(name, Object.fromEntries(parts));
  const facts = new SurfaceFacts(whole);
  const bevels = bevelsOf(facts);
  return {
    ...whole,
    name,
    sets: { ...endsOf(whole), ...bevels },
    rounds: roundsOf(facts),
    bevels: Object.keys(bevels),
  };
}

function partOf(path: string, at: Vec3): Shape {
  const { mesh } = readMesh(readFileSync(path), path);
  const weld = weldOf(mesh);
  const positions = gather(mesh.positions, weld).map((x, i) => x + at[i % 3]!);
  return { name: path, positions, triangles: solvedTriangles(weld), sets: {}, rounds: [], bevels: [] };
}

/** `x low` … `z high`. */
function endsOf({ positions }: Shape): Record<string, number[]> {
  const all = Array.from({ length: positions.length / 3 }, (_, v) => v);
  return Object.fromEntries(
    (['x', 'y', 'z'] as const).flatMap((letter, axis) => {
      const of = (v: number) => row(positions, v)[axis]!;
      const [low, high] = [Math.min(...all.map(of)), Math.max(...all.map(of))];
      const reach = near * (high - low);
      return [
        [`${letter} low`, all.filter((v) => of(v) <= low + reach)],
        [`${letter} high`, all.filter((v) => of(v) >= high - reach)],
      ];
    }),
  );
}
