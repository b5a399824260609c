import type { ParameterValues } from '../../src/methods/values/index.ts';
import { asDrawn, type Case, meshed } from './cases.ts';
import { type Stretching, stretched, turnedHandles } from './gestures.ts';
import { wantedRatio } from './limits.ts';
import { Judge, type Measures } from './measures.ts';
import { oblique, type Shape, turned } from './shape.ts';
import { type Reshaped, reshaped } from './solved.ts';
import { lateMoves, type Moves } from './stillness.ts';

/** A gesture that was tried. */
export interface Trial {
  readonly shape: string;
  /** With its factor. */
  readonly gesture: string;
  /** Name of the mesh or of the method, whichever the trials differ by. */
  readonly by: string;
  /** By what radii were to change. */
  readonly wanted: number;
  /** The sentence of the refusal where it was refused. */
  readonly result: Judged | string;
}

export interface Judged extends Measures {
  readonly run: Reshaped;
  /** What its last fifth of iterations moved. */
  readonly late: Moves;
}

/** Methods and readings, by names that a table can show. */
export const methods: Readonly<Record<string, ParameterValues>> = {
  tuned: {},
  published: { reading: 'published' },
  '3D ALUP': { variant: 'alup' },
  Poisson: { variant: 'poisson' },
  ARAP: { variant: 'arap' },
  conformal: { variant: 'conformal' },
};

/** All gestures of a shape by all methods. */
export async function byMethod(made: Case): Promise<Trial[]> {
  const shape = meshed(made);
  const trials: Trial[] = [];
  for (const [by, values] of Object.entries(methods))
    trials.push(...(await tried(made, shape, by, { values })));
  return trials;
}

/** All gestures of a shape on other meshes of it, tuned. */
export async function byMesh(made: Case): Promise<Trial[]> {
  return [
    ...(await tried(made, meshed(made, 0.5), 'edges ×0.5')),
    ...(await tried(made, meshed(made), 'edges ×1')),
    ...(await tried(made, meshed(made, 2), 'edges ×2')),
    ...(await tried(made, meshed(made), 'turned', { isTurned: true })),
    ...(made.isDrawn ? await tried(made, asDrawn(made), 'as drawn') : []),
  ];
}

async function tried(
  made: Case,
  shape: Shape,
  by: string,
  { values = {}, isTurned = false }: { values?: ParameterValues; isTurned?: boolean } = {},
): Promise<Trial[]> {
  const judge = new Judge(isTurned ? turned(shape, oblique) : shape);
  const trials: Trial[] = [];
  for (const [name, gesture] of Object.entries(made.gestures)) {
    trials.push({
      shape: made.name,
      gesture: `${name} ×${gesture.factor}`,
      by,
      wanted: wantedRatio(made, gesture),
      result: await judged(shape, judge, gesture, values, isTurned),
    });
  }
  return trials;
}

async function judged(
  shape: Shape,
  judge: Judge,
  gesture: Stretching,
  values: ParameterValues,
  isTurned: boolean,
): Promise<Judged | string> {
  const there = isTurned ? turned(shape, oblique) : shape;
  const handles = isTurned ? turnedHandles(stretched(shape, gesture), oblique) : stretched(shape, gesture);
  const ways: Float64Array[] = [];
  try {
    const run = await reshaped(there, handles, values, (at) => ways.push(at.slice()));
    return { ...judge.measure(run.positions, handles), run, late: lateMoves(there, ways) };
  } catch (error) {
    return (error as Error).message;
  }
}
