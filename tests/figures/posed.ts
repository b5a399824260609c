import { objText } from '../fixtures/mesh-files.ts';
import { patch } from '../fixtures/shapes.ts';
import type { Figure, FigureMesh } from './figure.ts';

/** A square sheet of a unit, lying. */
const sheet: FigureMesh = {
  title: 'sheet.obj',
  path: 'public/docs/figures/sheet.obj',
  format: 'OBJ',
  bytes: () => Buffer.from(objText(patch({ columns: 31, rows: 31 }, (s, t) => [s - 0.5, 0, 0.5 - t]))),
};

/** Handles: a second step that poses, and what the three kinds of stiffness do. */
export const posedFigures: readonly Figure[] = [
  {
    id: 'posed',
    of: '2019, Fig. 26',
    caption: 'A second step poses what the first has carved: the base is held and the ears are pulled.',
    paper: 'a carved figure that is bent by as-rigid-as-possible deformation',
    async act(hand) {
      await hand.slides('Cubeness', 0.6);
      await hand.clicks('Add a step');
      await hand.page.getByRole('menuitem', { name: 'Pose' }).click();
      await hand.rests();
      await hand.takes('Move');
      await hand.slides('Size', 0.35);
      await hand.drags('Pull', [640, 270], [650, 230], [640, 180], [620, 150]);
    },
  },
  ...(
    [
      ['arap', 'Soft', 'bends smoothly'],
      ['farap', 'Crisp', 'folds sharply between triangles'],
      ['acap', 'Elastic', 'keeps its angles and changes its sizes'],
    ] as const
  ).map(
    ([id, edges, does]): Figure => ({
      id: `sheet-${id}`,
      of: '2021, Fig. 11',
      caption: `The centre of a sheet is pulled up, its border is shrunk: with ${edges.toLowerCase()} edges (${id.toUpperCase()}) it ${does}.`,
      paper: 'a sheet with the same handles under the three regularizers',
      mesh: sheet,
      async act(hand) {
        await hand.chooses('Pose');
        await hand.takes('Select');
        await hand.clicksAt([759, 440]);
        await hand.clicks('Move');
        await hand.keys('Scale', 's.75');
        await hand.clicks('Let Base go');
        await hand.takes('Select');
        await hand.chooses('Brush');
        await hand.sweeps([589, 406], [594, 409]);
        await hand.clicks('Move');
        await hand.keys('Move', 'gy.4');
        await hand.chooses(edges);
      },
    }),
  ),
];
