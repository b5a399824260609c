import { farthest, markdownTable, percent } from '../benchmarks/numbers.ts';
import { type Case, meshed } from './cases.ts';
import { stretched, turnedHandles } from './gestures.ts';
import { oblique, type Shape, turned } from './shape.ts';
import { shuffled } from './shuffled.ts';
import { reshaped } from './solved.ts';
import { diagonalOf } from './surface-facts.ts';

/** How far two answers may be apart, as shares of the diagonal. */
export const sameness = { turned: 8e-4, shuffled: 1e-5 } as const;

type Apart = Record<keyof typeof sameness, number>;

/** How far the answers for a mesh that lies otherwise, and for one in another order, are from that for the mesh itself. */
export async function apart(shape: Shape, handles: ReturnType<typeof stretched>): Promise<Apart> {
  const { positions } = await reshaped(shape, handles);
  const there = await reshaped(turned(shape, oblique), turnedHandles(handles, oblique));
  const other = shuffled(shape);
  const again = await reshaped(other.mesh, other.handles(handles));
  const diagonal = diagonalOf(shape.positions);
  return {
    turned: farthest(turned({ ...shape, positions }, oblique).positions, there.positions) / diagonal,
    shuffled: farthest(other.back(again.positions), positions) / diagonal,
  };
}

/** The gestures, tuned, whose answers depend on how a mesh lies or on the order of its vertices. */
export async function samenessTable(cases: readonly Case[]): Promise<string> {
  const rows: string[][] = [];
  let count = 0;
  for (const made of cases) {
    for (const scale of [1, 2]) {
      const shape = meshed(made, scale);
      for (const [name, gesture] of Object.entries(made.gestures)) {
        count++;
        const off = await apart(shape, stretched(shape, gesture));
        if (off.turned < sameness.turned && off.shuffled < sameness.shuffled) continue;
        const edges = `edges ×${scale}`;
        rows.push([
          made.name,
          `${name} ×${gesture.factor}`,
          edges,
          percent(off.turned),
          percent(off.shuffled),
        ]);
      }
    }
  }
  const titles = ['shape', 'gesture', 'mesh', 'turned', 'in another order'];
  return `${rows.length} of ${count} runs:\n\n${markdownTable(titles, rows)}`;
}
