import type { MethodDescriptor } from './descriptor.ts';
import { iterations, parts } from './shared-parameters.ts';

export const polycube: MethodDescriptor = {
  id: 'polycube',
  title: 'PolyCube',
  summary: 'Turn every face to the closest of a few directions and let the details go: a mesh of boxes.',
  paper: 'Normal-Driven Spherical Shape Analogies, 2021, §5.1',
  shading: 'flat',
  targets: () => ({ style: 'directions', lookedUpFrom: 'output' }),
  parameters: [
    {
      name: 'directions',
      kind: 'style',
      mapping: 'closest',
      label: 'Directions',
      doc: 'Where faces may look: a primitive (cube, hexagonal-prism …), a convex mesh file, or a list of normals [[x, y, z], …].',
      invalidates: 'targets',
      default: 'cube',
    },
    {
      name: 'lambda',
      kind: 'number',
      label: 'Pace',
      doc: 'λ of Eq. 3: how far faces turn in one iteration. Each starts anew from what the last one left; slower keeps triangles better.',
      invalidates: 'targets',
      default: 1,
      min: 0,
      max: 100,
      unit: '',
      slider: { min: 0, max: 4, step: 0.05 },
    },
    {
      name: 'smoothing',
      kind: 'number',
      label: 'Smoothing',
      doc: 'How far the vertices of triangles that became bad move to the mean of their neighbours in one iteration (2021, §5.1); it shrinks a little.',
      invalidates: 'targets',
      advanced: true,
      default: 0.2,
      min: 0,
      max: 1,
      unit: '',
    },
    parts,
    iterations(50),
  ],
};
