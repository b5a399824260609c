import type {
  ChoiceParameter,
  HandlesParameter,
  MethodDescriptor,
  NumberParameter,
  ParameterDescriptor,
  ScalarsParameter,
} from './descriptor.ts';

export const handles: HandlesParameter = {
  name: 'handles',
  kind: 'handles',
  label: 'Handles',
  doc: 'Vertices held at given places, in the file’s units; a part without a handle keeps its centre.',
  invalidates: 'system',
};

const acceleration: ChoiceParameter = {
  name: 'acceleration',
  kind: 'choice',
  label: 'Acceleration',
  doc: 'How each iteration builds on those before: Nesterov’s extrapolation, relaxation by 1.8, or not at all as in the papers.',
  invalidates: 'targets',
  advanced: true,
  default: 'nesterov',
  choices: ['nesterov', 'relaxed', 'none'],
};

const stopOn: ChoiceParameter = {
  name: 'stopOn',
  kind: 'choice',
  label: 'Stop on',
  doc: 'What the tolerance is held against: the longest move as a share of the way so far (2019, §3.1), or the energy’s relative decrease.',
  invalidates: 'targets',
  advanced: true,
  default: 'displacement',
  choices: ['displacement', 'energy'],
};

const tolerance: NumberParameter = {
  name: 'tolerance',
  kind: 'number',
  label: 'Tolerance',
  doc: 'Stop when an iteration changes less than this share of what “stop on” names.',
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
  acceleration,
  stopOn,
  tolerance,
  maxIterations,
];

export const regularizer: ChoiceParameter = {
  name: 'regularizer',
  kind: 'choice',
  label: 'Keeps',
  doc: 'What details keep: arap their shape around each vertex, farap that of each triangle while edges bend, acap their angles while sizes may change (2021, §4.1).',
  invalidates: 'all',
  advanced: true,
  default: 'arap',
  choices: ['arap', 'farap', 'acap'],
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

export const arap: MethodDescriptor = {
  id: 'arap',
  title: 'As rigid as possible',
  summary: 'Move handles and let the rest follow with as little stretching as possible.',
  paper: 'Sorkine and Alexa 2007, spokes and rims of Chao et al. 2010',
  parameters: [regularizer, ...shared],
};

export const cubic: MethodDescriptor = {
  id: 'cubic',
  title: 'Cubic',
  summary: 'Carve the mesh into the style of a cube while its details stay.',
  paper: 'Cubic Stylization, Liu and Jacobson 2019',
  parameters: [
    {
      name: 'lambda',
      kind: 'number',
      label: 'Cubeness',
      doc: 'λ of Eq. 1: how strongly normals are drawn to the axes. Finer meshes need less for the same look.',
      invalidates: 'weights',
      default: 0.2,
      min: 0,
      max: 100,
      unit: '',
      slider: { min: 0, max: 2, step: 0.01 },
    },
    lambdaPerVertex,
    {
      name: 'lambdaAxes',
      kind: 'vector',
      label: 'Axes',
      doc: 'What λ is taken times for each axis of the cube: the style is then a box of such edges (2019, §4). 0 leaves an axis out.',
      invalidates: 'weights',
      advanced: true,
      default: [1, 1, 1],
      min: 0,
      max: 100,
    },
    {
      name: 'polyhedron',
      kind: 'choice',
      label: 'Polyhedron',
      doc: 'Whose faces the normals are drawn to: a cube’s, those of another centrally symmetric polyhedron, or of a matrix B of your own (2019, §4), whose rows are the polyhedron’s edges.',
      invalidates: 'weights',
      default: 'cube',
      choices: ['cube', 'hexagonal-prism', 'rhombic-dodecahedron', 'truncated-octahedron'],
      maxRows: 12,
    },
    {
      name: 'orientation',
      kind: 'rotation',
      label: 'Orientation',
      doc: 'How the cube or polyhedron is turned against the file’s axes, as a quaternion x, y, z, w of any length.',
      invalidates: 'weights',
      advanced: true,
      default: [0, 0, 0, 1],
    },
    {
      name: 'frames',
      kind: 'rotations',
      label: 'Frames',
      doc: 'Regions of the mesh with an orientation of their own (2019, §4, local coordinate frames); vertices of none have “orientation”.',
      invalidates: 'weights',
      advanced: true,
    },
    {
      name: 'localStep',
      kind: 'choice',
      label: 'Local step',
      doc: 'How each vertex finds its rotation: exactly by Newton’s method, or by the printed ADMM (2019, §3.1).',
      invalidates: 'weights',
      advanced: true,
      default: 'exact',
      choices: ['exact', 'admm'],
    },
    ...shared,
  ],
};
