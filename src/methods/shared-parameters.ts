import type { ChoiceParameter } from './values/choice.ts';
import type { HandlesParameter } from './values/handles.ts';
import type { ParameterDescriptor } from './values/index.ts';
import type { NumberParameter } from './values/number.ts';
import type { PlanesParameter } from './values/planes.ts';
import type { ScalarsParameter } from './values/scalars.ts';
import type { SphereFieldParameter } from './values/sphere-field.ts';

export const handles: HandlesParameter = {
  name: 'handles',
  kind: 'handles',
  label: 'Handles',
  doc: 'Vertices held at given places, in the file’s units; a part without a handle keeps its centre.',
  invalidates: 'system',
};

export const planes: PlanesParameter = {
  name: 'planes',
  kind: 'planes',
  label: 'Planes',
  doc: 'Vertices that stay on a plane, normal·x = offset in the file’s units (2019, §4); along its planes a part keeps its centre.',
  invalidates: 'system',
  advanced: true,
};

export const parts: ChoiceParameter = {
  name: 'parts',
  kind: 'choice',
  label: 'Parts that touch',
  doc: 'Whether parts that touch or cross each other stay in touch, or each is shaped as if it were alone.',
  hint: 'Whether parts that touch stay in touch, or each is shaped as if it were alone.',
  invalidates: 'system',
  advanced: true,
  default: 'together',
  choices: ['together', 'free'],
  labels: { together: 'stay together', free: 'each alone' },
};

const acceleration: ChoiceParameter = {
  name: 'acceleration',
  kind: 'choice',
  label: 'Speed-up',
  doc: 'How each iteration builds on those before: Nesterov’s extrapolation, relaxation by 1.8, or not at all as in the papers.',
  hint: 'How each iteration builds on those before: boldly, gently, or not at all as in the papers.',
  invalidates: 'targets',
  advanced: true,
  default: 'nesterov',
  choices: ['nesterov', 'relaxed', 'none'],
  labels: { nesterov: 'bold', relaxed: 'gentle', none: 'none' },
};

const stopOn: ChoiceParameter = {
  name: 'stopOn',
  kind: 'choice',
  label: 'Stop by',
  doc: 'What the tolerance is held against: the longest move as a share of the way so far (2019, §3.1), or the energy’s relative decrease.',
  hint: 'Whether the run ends when the mesh hardly moves, or when its energy hardly falls.',
  invalidates: 'targets',
  advanced: true,
  default: 'displacement',
  choices: ['displacement', 'energy'],
  labels: { displacement: 'movement', energy: 'energy' },
};

const tolerance: NumberParameter = {
  name: 'tolerance',
  kind: 'number',
  label: 'Tolerance',
  doc: 'Stop when an iteration changes less than this share of what “stop on” names.',
  hint: 'The run ends when an iteration changes less than this share. Smaller is finer and slower.',
  invalidates: 'targets',
  advanced: true,
  default: 3e-3,
  min: 0,
  max: 1,
  unit: '',
};

const maxIterations: NumberParameter = {
  name: 'maxIterations',
  kind: 'integer',
  label: 'Iterations at most',
  doc: 'Stop after this many local/global iterations even if the tolerance is not met.',
  hint: 'The run ends after so many iterations at the latest.',
  invalidates: 'targets',
  advanced: true,
  default: 1000,
  min: 0,
  max: 1_000_000,
  unit: '',
};

/** How long a method runs whose targets follow the output: nothing else says when it is done. */
export function iterations(usual: number): NumberParameter {
  return {
    name: 'maxIterations',
    kind: 'integer',
    label: 'Iterations',
    doc: 'Stop after this many; targets follow the output, and the shape goes on changing a little.',
    hint: 'The run ends after so many iterations; the shape would go on changing a little.',
    invalidates: 'targets',
    advanced: true,
    default: usual,
    min: 0,
    max: 1_000_000,
    unit: '',
  };
}

/** What every local/global method with targets that stay ends its list with. */
export const shared: readonly ParameterDescriptor[] = [
  handles,
  planes,
  parts,
  acceleration,
  stopOn,
  tolerance,
  maxIterations,
];

export const regularizer: ChoiceParameter = {
  name: 'regularizer',
  kind: 'choice',
  label: 'Edges',
  doc: 'What details keep: arap their shape around each vertex, farap that of each triangle while edges bend, acap their angles while sizes may change (2021, §4.1).',
  hint: 'Soft keeps details rounded, crisp lets edges fold sharply, elastic lets parts grow and shrink.',
  invalidates: 'all',
  toCompare: true,
  default: 'arap',
  choices: ['arap', 'farap', 'acap'],
  labels: { arap: 'Soft', farap: 'Crisp', acap: 'Elastic' },
};

/** @param max the highest λ of a vertex, as of the method's own λ */
export const strengthByVertex = (max: number): ScalarsParameter => ({
  name: 'lambdaPerVertex',
  kind: 'scalars',
  label: 'Strength by vertex',
  doc: 'λ of each vertex of the file’s position list, in place of the one λ; places that the file stores twice get the mean.',
  invalidates: 'weights',
  advanced: true,
  min: 0,
  max,
});

export const lambdaPerVertex = strengthByVertex(100);

export const lambdaOnGaussMap: SphereFieldParameter = {
  name: 'lambdaOnGaussMap',
  kind: 'sphereField',
  label: 'Strength by direction',
  doc: 'What share of λ a surface has by the way it looks, as a grey picture of the sphere (2019, §4, Gauss map); it may be painted.',
  invalidates: 'weights',
  advanced: true,
};
