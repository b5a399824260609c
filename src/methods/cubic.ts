import type { MethodDescriptor } from './descriptor.ts';
import { lambdaOnGaussMap, lambdaPerVertex, shared } from './shared-parameters.ts';
import { startingLambda } from './starting-lambda.ts';
import type { Directions } from './values/points.ts';

const slant = Math.sqrt(3) / 2;

/** B of the named polyhedra, as `wasm/core/methods/local_global/cubic/polyhedron.cpp` has them: edges and their lengths. */
const polyhedronRows = {
  cube: [
    [1, 0, 0],
    [0, 1, 0],
    [0, 0, 1],
  ],
  'hexagonal-prism': [
    [2 / 3, 0, 0],
    [1 / 3, 0, (2 / 3) * slant],
    [-1 / 3, 0, (2 / 3) * slant],
    [0, 1, 0],
  ],
  'rhombic-dodecahedron': [1, -1].flatMap((y) =>
    [1, -1].map((z) => [slant / 2, (slant / 2) * y, (slant / 2) * z] as const),
  ),
  'truncated-octahedron': ([0, 1, 2] as const).flatMap((axis) =>
    [1, -1].map((sign) => {
      const row: [number, number, number] = [0, 0, 0];
      row[axis] = Math.SQRT1_2 / 2;
      row[(axis + 1) % 3] = (Math.SQRT1_2 / 2) * sign;
      return row;
    }),
  ),
} satisfies Record<string, Directions>;

export const cubic: MethodDescriptor = {
  id: 'cubic',
  title: 'Cubic',
  intent: 'carve',
  summary: 'Carve the mesh into the style of a cube while its details stay.',
  paper: 'Cubic Stylization, Liu and Jacobson 2019',
  shading: 'smooth',
  // Its solid has a Gauss map, though the method carves without one.
  targets: () => ({ style: 'polyhedron', lookedUpFrom: 'output' }),
  startingValues: ({ report }) => ({ lambda: startingLambda(report.typicalPart) }),
  parameters: [
    {
      name: 'lambda',
      kind: 'number',
      label: 'Cubeness',
      doc: 'λ of Eq. 1: how strongly normals are drawn to the axes. Finer meshes need less for the same look.',
      hint: 'How strongly the mesh is drawn to the cube. Finer meshes need less.',
      invalidates: 'weights',
      default: 0.2,
      min: 0,
      max: 100,
      unit: '',
      slider: { min: 0, max: 2, step: 0.01 },
    },
    lambdaPerVertex,
    lambdaOnGaussMap,
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
      label: 'Solid',
      doc: 'Whose faces the normals are drawn to: a cube’s, those of another centrally symmetric polyhedron, or of a matrix B of your own (2019, §4), whose rows are the polyhedron’s edges.',
      hint: 'The solid that the mesh is drawn to.',
      invalidates: 'weights',
      default: 'cube',
      choices: ['cube', 'hexagonal-prism', 'rhombic-dodecahedron', 'truncated-octahedron'],
      labels: {
        cube: 'Cube',
        'hexagonal-prism': 'Hexagonal prism',
        'rhombic-dodecahedron': 'Rhombic dodecahedron',
        'truncated-octahedron': 'Truncated octahedron',
      },
      maxRows: 12,
      rows: polyhedronRows,
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
      hint: 'How each point finds its turn: exactly, or in the small steps of the paper.',
      invalidates: 'weights',
      advanced: true,
      default: 'exact',
      choices: ['exact', 'admm'],
      labels: { exact: 'exact', admm: 'as printed' },
    },
    ...shared,
  ],
};
