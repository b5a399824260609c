import type { HandlesParameter, MethodDescriptor, NumberParameter } from './descriptor.ts';

const handles: HandlesParameter = {
  name: 'handles',
  kind: 'handles',
  label: 'Handles',
  doc: 'Vertices held at given places, in the file’s units; a part without a handle keeps its centre.',
  invalidates: 'system',
};

const tolerance: NumberParameter = {
  name: 'tolerance',
  kind: 'number',
  label: 'Tolerance',
  doc: 'Stop when no vertex moved further in one iteration than this share of its way so far (2019, §3.1).',
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

export const arap: MethodDescriptor = {
  id: 'arap',
  title: 'As rigid as possible',
  summary: 'Move handles and let the rest follow with as little stretching as possible.',
  paper: 'Sorkine and Alexa 2007, spokes and rims of Chao et al. 2010',
  parameters: [handles, tolerance, maxIterations],
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
    handles,
    tolerance,
    maxIterations,
  ],
};
