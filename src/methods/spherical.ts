import type { MethodDescriptor } from './descriptor.ts';

export const spherical: MethodDescriptor = {
  id: 'spherical',
  title: 'To the sphere',
  summary:
    'Let a closed mesh without handles flow to a sphere while its angles stay: how a style mesh is read.',
  paper:
    'Conformalized mean curvature flow, Kazhdan et al. 2012, for Normal-Driven Spherical Shape Analogies, 2021, §3.1',
  shading: 'smooth',
  parameters: [
    {
      name: 'timeStep',
      kind: 'number',
      label: 'Time step',
      doc: 'τ of the flow at area 1: smaller follows it more closely and takes more iterations. It grows to its tenfold on the way.',
      invalidates: 'targets',
      advanced: true,
      default: 1e-3,
      min: 1e-6,
      max: 1,
      unit: '',
    },
    {
      name: 'tolerance',
      kind: 'number',
      label: 'Tolerance',
      doc: 'Stop when the squared move of an iteration, averaged over the surface, is below this share of its area.',
      invalidates: 'targets',
      advanced: true,
      default: 1e-9,
      min: 0,
      max: 1,
      unit: '',
    },
    {
      name: 'maxIterations',
      kind: 'integer',
      label: 'Iterations at most',
      doc: 'Stop after this many iterations, and then do not round the result to the exact sphere.',
      invalidates: 'targets',
      advanced: true,
      default: 300,
      min: 0,
      max: 1_000_000,
      unit: '',
    },
  ],
};
