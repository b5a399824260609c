import type { MethodDescriptor } from './descriptor.ts';
import { lambdaOnGaussMap, lambdaPerVertex, regularizer, shared } from './shared-parameters.ts';
import { startingRegularizer, startingStrength } from './starting-lambda.ts';

export const analogy: MethodDescriptor = {
  id: 'analogy',
  title: 'Style',
  intent: 'carve',
  summary: 'Give the mesh the style of another shape: its sides turn to face as the style’s do.',
  paper: 'Normal-Driven Spherical Shape Analogies, 2021',
  shading: 'smooth',
  targets: ({ dynamicTargets }) => ({
    style: 'style',
    lookedUpFrom: dynamicTargets === true ? 'output' : 'input',
  }),
  startingValues: ({ report, style }) =>
    style ? { lambda: startingStrength(style), regularizer: startingRegularizer(report, style) } : {},
  parameters: [
    {
      name: 'style',
      kind: 'style',
      label: 'Style',
      doc: 'The shape to borrow from: a primitive (cube, icosahedron …), a style mesh (oloid, jessen …) or a closed mesh file.',
      invalidates: 'weights',
      default: 'cube',
    },
    {
      name: 'mapping',
      kind: 'choice',
      label: 'Mapping',
      doc: 'How the style is read: the closest normal of a convex shape, or its surface on the sphere (2021, §3.1); auto takes what suits it.',
      hint: 'How the style is read: by its closest side, or by its whole surface.',
      invalidates: 'weights',
      advanced: true,
      isForLibrary: true,
      default: 'auto',
      choices: ['auto', 'closest', 'spherical'],
    },
    {
      name: 'lambda',
      kind: 'number',
      label: 'Strength',
      doc: 'λ of Eq. 1: how strongly normals are drawn to the style’s. Finer meshes need less for the same look.',
      hint: 'How strongly the mesh takes after the style. Finer meshes need less.',
      invalidates: 'weights',
      default: 1,
      min: 0,
      max: 100,
      unit: '',
      slider: { min: 0, max: 10, step: 0.05 },
    },
    regularizer,
    {
      name: 'dynamicTargets',
      kind: 'flag',
      label: 'Look again as it goes',
      doc: 'Look the targets up from the output’s normals in every iteration, not from the input’s once; no acceleration then.',
      hint: 'Looks anew in every iteration where each side should face: bolder, and slower.',
      invalidates: 'weights',
      advanced: true,
      default: false,
    },
    lambdaPerVertex,
    lambdaOnGaussMap,
    ...shared,
  ],
};
