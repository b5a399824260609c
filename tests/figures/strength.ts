import { type Figure, suzanne } from './figure.ts';

/** Strength that is painted, on the mesh and by direction, or differs by axis. */
export const strengthFigures: readonly Figure[] = [
  {
    id: 'painted-mesh',
    of: '2019, Fig. 19',
    caption: 'Strength is painted on the mesh: body full, head none.',
    paper: 'more strength on one region and less on another, for a shape to sit on',
    async act(hand) {
      await hand.takes('Paint');
      await hand.unfolds('Brush');
      await hand.slides('Size', 0.75);
      await hand.slides('Force', 1);
      await hand.slides('Hardness', 0.9);
      await hand.ticks('Mirror');
      await hand.drags(
        'Paint strength',
        [400, 290],
        [400, 350],
        [430, 380],
        [470, 320],
        [430, 270],
        [500, 300],
        [680, 290],
        [560, 270],
      );
      await hand.slides('Cubeness', 0.75);
    },
  },
  {
    id: 'painted-ball',
    of: '2019, Fig. 20',
    caption:
      'Strength is painted on the ball of directions: what looks left is cubic, what looks right stays smooth.',
    paper: 'an owl, cubic where its surface looked to the left',
    mesh: suzanne,
    async act(hand) {
      await hand.takes('Paint');
      await hand.clicks('None');
      await hand.clicks('More');
      await hand.unfolds('Brush');
      await hand.slides('Force', 1);
      await hand.strokesBall(
        [-0.95, 0],
        [-0.8, 0.5],
        [-0.6, 0.75],
        [-0.7, 0],
        [-0.6, -0.75],
        [-0.45, -0.5],
        [-0.45, 0],
        [-0.45, 0.5],
      );
      await hand.slides('Cubeness', 0.8);
    },
  },
  ...(
    [
      ['x', [791, 436], [850, 446]],
      ['y', [592, 195], [592, 135]],
      ['z', [484, 473], [440, 492]],
    ] as const
  ).map(
    ([axis, from, to]): Figure => ({
      id: `stretched-${axis}`,
      of: '2019, Fig. 21',
      caption: `The cube is stretched along ${axis}.`,
      paper: 'shapes that are biased towards each of the axes',
      async act(hand) {
        await hand.takes('Cube');
        await hand.drags('Stretch the cube', from, to);
        await hand.slides('Cubeness', 0.6);
      },
    }),
  ),
];
