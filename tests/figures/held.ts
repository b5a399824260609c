import type { Place } from '../browser/support/hands.ts';
import type { Figure } from './figure.ts';

/** A line around the rabbit’s head and ears, as it is seen at first. */
const aroundHead: readonly Place[] = [
  [335, 250],
  [420, 200],
  [500, 230],
  [560, 180],
  [720, 180],
  [730, 340],
  [530, 345],
  [440, 440],
  [360, 440],
  [335, 300],
];

/** Parts that are held: as they were, against a wall, on planes. */
export const heldFigures: readonly Figure[] = [
  {
    id: 'held-head',
    of: '2019, Fig. 4, top',
    caption: 'The head is held as it was in the file, the rest becomes a bench.',
    paper: 'parts of a shape are fixed, in the manner of a stone bench in the shape of a jaguar',
    async act(hand) {
      await hand.lassoes(...aroundHead);
      await hand.clicks('Hold');
      await hand.slides('Cubeness', 0.75);
    },
  },
  {
    id: 'against-wall',
    of: '2019, Fig. 4, bottom',
    caption:
      'The far half is laid flat against a wall, point by point; the near half stands out from it as a relief.',
    paper: 'points are held against a wall, in the manner of the winged bulls of Assyria',
    differs: 'The wall itself is not drawn.',
    async act(hand) {
      // From the front, its left half is the far one.
      await hand.sweeps([420, 650], [680, 650]);
      await hand.lassoes([336, 120], [530, 120], [530, 720], [336, 720], [336, 300]);
      await hand.clicks('Move');
      await hand.keys('Scale', 'sz0');
      await hand.slides('Cubeness', 0.6);
    },
    async look(hand) {
      await hand.sweeps([420, 650], [715, 650]);
      await hand.zooms(3);
    },
  },
  {
    id: 'on-planes',
    of: '2019, Fig. 22',
    caption:
      'Feet and back are held on planes that are square to each other: a rabbit to hold books upright.',
    paper: 'parts lie on planes, so that the shape clings to a table',
    shows: 'Select',
    async act(hand) {
      // Level with the ground and square to its side.
      await hand.sweeps([420, 650], [480, 650], [480, 590]);
      await hand.takes('Select');
      await hand.chooses('Frame');
      await hand.ticks('Far side too');
      await hand.sweeps([340, 612], [850, 720]);
      await hand.clicks('On a plane');
      await hand.sweeps([690, 300], [850, 625]);
      await hand.clicks('On a plane');
      await hand.clicks('None');
      await hand.slides('Cubeness', 0.6);
    },
    async look(hand) {
      await hand.takes('Turn');
      await hand.sweeps([420, 650], [350, 650], [350, 685]);
      await hand.takes('Select');
    },
  },
];
