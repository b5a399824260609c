import { markdownTable } from '../benchmarks/numbers.ts';
import { asDrawn, type Case, meshed } from './cases.ts';
import { stretched } from './gestures.ts';
import { Judge } from './measures.ts';
import type { Shape } from './shape.ts';
import { reshaped } from './solved.ts';

/** What comes of a shape whose ends are to be a fifth as far apart as they are. */
export async function collapsed(made: Case, shape: Shape): Promise<string> {
  const handles = stretched(shape, { ...Object.values(made.gestures)[0]!, factor: 0.2 });
  try {
    const { positions, warnings } = await reshaped(shape, handles);
    const { flipped } = new Judge(shape).measure(positions, handles);
    if (flipped === 0) return 'nothing turns over';
    const isSaid = warnings.some((warning) => /(fold|turns?) over/.test(warning));
    return `${flipped} of ${shape.triangles.length / 3} turn over, ${isSaid ? 'and it says so' : '**unsaid**'}`;
  } catch (error) {
    return (error as Error).message.includes('inside out') ? 'refused' : (error as Error).message;
  }
}

export async function collapseTable(cases: readonly Case[]): Promise<string> {
  const rows: string[][] = [];
  for (const made of cases) {
    rows.push([
      made.name,
      await collapsed(made, meshed(made)),
      await collapsed(made, meshed(made, 2)),
      made.isDrawn ? await collapsed(made, asDrawn(made)) : '–',
    ]);
  }
  return markdownTable(['shape', 'edges ×1', 'edges ×2', 'as drawn'], rows);
}
