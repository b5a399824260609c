import type { MethodDescriptor } from './descriptor.ts';
import { handles, iterations, parts, planes, strengthByVertex } from './shared-parameters.ts';

export const developable: MethodDescriptor = {
  id: 'developable',
  title: 'Paper',
  intent: 'fold',
  summary: 'Fold the mesh as if of paper: pieces that unroll flat, with creases between them.',
  paper: 'Normal-Driven Spherical Shape Analogies, 2021, §5.2',
  shading: 'flat',
  parameters: [
    {
      name: 'lambda',
      kind: 'number',
      label: 'Strength',
      doc: 'λ of Eq. 3: how strongly normals are drawn to what unrolls, against the shape of each triangle.',
      hint: 'How strongly the mesh is drawn to what unrolls flat.',
      invalidates: 'weights',
      advanced: true,
      default: 20,
      min: 0,
      max: 1000,
      unit: '',
    },
    {
      name: 'creases',
      kind: 'number',
      label: 'Creases',
      doc: 'Share of the vertices, the most bent ones, that may stay bent; the others are to become flat. 1 makes many small pieces, less makes larger ones, 0 only smooths (App. E).',
      hint: 'More creases make many small sheets, fewer make large ones, none only smooths.',
      invalidates: 'weights',
      default: 0.65,
      min: 0,
      max: 1,
      unit: '',
      slider: { min: 0, max: 1, step: 0.01 },
    },
    strengthByVertex(1000),
    handles,
    planes,
    parts,
    iterations(150),
  ],
};
