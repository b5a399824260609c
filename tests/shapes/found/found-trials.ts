import type { ParameterValues } from '../../../src/methods/values/index.ts';
import { type Stretching, stretched } from '../gestures.ts';
import { Judge, type Measures } from '../measures.ts';
import type { Shape } from '../shape.ts';
import { type Reshaped, reshaped } from '../solved.ts';
import { normalsOf, regions, SurfaceFacts } from '../surface-facts.ts';
import { changeOfThickness, type Wall, wallsOf } from '../walls.ts';
import { Asked } from './asked.ts';
import { keptRound } from './leaning.ts';

/** A gesture on a shape that was found, by one method. */
export interface FoundTrial {
  readonly shape: string;
  readonly faces: number;
  /** With its factor. */
  readonly gesture: string;
  readonly by: string;
  /** The sentence of the refusal where it was refused. */
  readonly result: FoundResult | string;
}

/** Rounds, bevels and thickness are those of what the gesture does not change by itself. */
export interface FoundResult extends Measures {
  readonly run: Reshaped;
}

/** Every gesture by some methods. */
export async function foundTrials(
  shape: Shape,
  gestures: Readonly<Record<string, Stretching>>,
  methods: Readonly<Record<string, ParameterValues>>,
): Promise<FoundTrial[]> {
  const judge = new Judge(shape);
  const facts = new SurfaceFacts(shape);
  const walls = wallsWithinParts(facts);
  const trials: FoundTrial[] = [];
  for (const [name, gesture] of Object.entries(gestures)) {
    const handles = stretched(shape, gesture);
    const asked = new Asked(shape, handles);
    const rounds = asked.rounds();
    const bevels = new Set(asked.bevels());
    const kept = walls.filter((wall) => asked.isWallAsked(wall));
    const measure = (run: Reshaped): FoundResult => {
      const all = judge.measure(run.positions, handles);
      const { positions } = run;
      const after = { positions, triangles: shape.triangles };
      return {
        ...all,
        rounds: rounds.map((round) => keptRound(shape, round, positions)),
        bevels: all.bevels.filter(({ name }) => bevels.has(name)),
        thickness: changeOfThickness(kept, after, normalsOf(after)),
        run,
      };
    };
    for (const [by, values] of Object.entries(methods)) {
      const result = await reshaped(shape, handles, values).then(measure, (error: Error) => error.message);
      const faces = shape.triangles.length / 3;
      trials.push({ shape: shape.name, faces, gesture: `${name} ×${gesture.factor}`, by, result });
    }
  }
  return trials;
}

/** Walls of one part each: what is between the faces of two that overlap is no wall. */
function wallsWithinParts(facts: SurfaceFacts): Wall[] {
  const partOf = new Map(
    regions(facts.normals.length, facts.pairs).flatMap((faces, k) => faces.map((face) => [face, k] as const)),
  );
  return wallsOf(facts).filter(({ face, behind }) => partOf.get(face) === partOf.get(behind));
}
