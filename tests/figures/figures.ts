import type { Hand } from './hand.ts';

/** A sample that is not the one which the page opens with. */
export interface FigureSample {
  readonly title: string;
  readonly path: string;
  /** Its own format, by its name in the export menu. */
  readonly format: string;
}

/** A figure of the papers, remade with the shapes that come with the page, in a window of 1200×800. */
export interface Figure {
  readonly id: string;
  /** The year of its paper and its number there. */
  readonly of: string;
  readonly caption: string;
  readonly sample?: FigureSample;
  readonly act: (hand: Hand) => Promise<void>;
}

export const figures: readonly Figure[] = [
  {
    id: 'held-base',
    of: '2019, Fig. 4, top',
    caption: 'The hind part is held as it was in the file; the rest becomes cubic.',
    async act(hand) {
      await hand.takes('Move');
      await hand.clicks('Hold');
      await hand.slides('Size', 0.5);
      await hand.drags('Hold', [700, 450], [730, 500], [700, 560], [740, 610]);
      await hand.slides('Cubeness', 0.6);
    },
  },
  {
    id: 'painted-back',
    of: '2019, Fig. 19',
    caption: 'Strength is painted on the mesh: the body is cubic, the head is not.',
    async act(hand) {
      await hand.takes('Paint');
      await hand.drags(
        'Paint strength',
        [430, 260],
        [450, 330],
        [440, 400],
        [500, 300],
        [700, 280],
        [560, 260],
      );
      await hand.drags(
        'Paint strength',
        [430, 260],
        [450, 330],
        [440, 400],
        [500, 300],
        [700, 280],
        [560, 260],
      );
      await hand.slides('Cubeness', 0.7);
    },
  },
  ...(['x', 'y', 'z'] as const).map(
    (axis): Figure => ({
      id: `stretched-${axis}`,
      of: '2019, Fig. 21',
      caption: `The cube is stretched along ${axis}.`,
      async act(hand) {
        await hand.takes('Cube');
        for (const other of ['x', 'y', 'z']) await hand.types(other, other === axis ? '1.6' : '0.4');
      },
    }),
  ),
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
      caption: `Another polyhedron in place of the cube: ${name.toLowerCase()}.`,
      async act(hand) {
        await hand.takes('Cube');
        await hand.clicks(name);
        await hand.rests();
        await hand.slides('Cubeness', 0.7);
      },
    }),
  ),
];
