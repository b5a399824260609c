import type { Figure } from './figure.ts';

/** Other solids than the cube, and cubes of their own for parts. */
export const polyhedronFigures: readonly Figure[] = [
  {
    id: 'own-cubes',
    of: '2019, Fig. 23',
    caption: 'The head has a cube of its own, which is turned; the body keeps the world’s.',
    paper: 'a figure whose hands are drawn to a cube that is turned against that of its body',
    async act(hand) {
      await hand.lassoes(
        [335, 250],
        [420, 200],
        [500, 230],
        [560, 180],
        [720, 180],
        [730, 340],
        [530, 345],
        [440, 440],
        [360, 440],
      );
      await hand.clicks('Cube of its own');
      await hand.slides('Cubeness', 0.65);
      await hand.drags('Turn the cube', [624, 332], [618, 367], [603, 398]);
    },
  },
  ...(
    [
      ['Hexagonal prism', 'hexagonal'],
      ['Rhombic dodecahedron', 'rhombic'],
      ['Truncated octahedron', 'truncated'],
    ] as const
  ).map(
    ([name, id]): Figure => ({
      id,
      of: '2019, Fig. 24',
      caption: `${name} in place of the cube.`,
      paper: 'shapes drawn to other polyhedra',
      async act(hand) {
        await hand.takes('Cube');
        await hand.clicks(name);
        await hand.slides('Cubeness', 0.6);
      },
    }),
  ),
  {
    id: 'irregular',
    of: '2019, Fig. 25',
    caption: 'An irregular solid, by four edges of one’s own.',
    paper: 'a shape drawn to an irregular polyhedron',
    async act(hand) {
      await hand.takes('Cube');
      await hand.clicks('Edges of your own');
      await hand.clicks('Add an edge');
      await hand.types('Edge 1, x', '0.7');
      await hand.types('Edge 1, y', '-0.2');
      await hand.types('Edge 2, y', '0.7');
      await hand.types('Edge 3, x', '0.4');
      await hand.types('Edge 3, z', '0.6');
      await hand.types('Edge 4, z', '-0.3');
      await hand.types('Edge 4, x', '0.2');
      await hand.types('Edge 4, y', '0.2');
      await hand.slides('Cubeness', 0.5);
    },
    look: (hand) => hand.zooms(1),
  },
];
