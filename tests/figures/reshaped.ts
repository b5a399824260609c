import { expect } from 'vitest';
import type { Place } from '../browser/support/hands.ts';
import { objText } from '../fixtures/mesh-files.ts';
import { asDrawn, caseOf, meshed } from '../shapes/cases.ts';
import { even, raw } from '../shapes/fineness.ts';
import { Judge, type Measures } from '../shapes/measures.ts';
import { rotation, type Shape, turned } from '../shapes/shape.ts';
import { cabinet } from './cabinet.ts';
import type { Figure, FigureMesh, Outcome } from './figure.ts';
import type { Hand } from './hand.ts';
import { wagon } from './wagon.ts';

/** A shape that stands on the page, whose z goes up where it was made. */
class Stand {
  readonly mesh: FigureMesh;
  readonly #make: () => Shape;
  #shape: Shape | undefined;

  constructor(title: string, make: () => Shape) {
    this.#make = make;
    this.mesh = {
      title,
      path: `public/docs/figures/${title}`,
      format: 'OBJ',
      bytes: () => Buffer.from(objText(this.shape)),
    };
  }

  get shape(): Shape {
    this.#shape ??= turned(this.#make(), rotation([1, 0, 0], -90));
    return this.#shape;
  }

  measure({ positions, handles }: Outcome): Measures {
    return new Judge(this.shape).measure(positions, handles);
  }
}

const table = new Stand('table.obj', () => meshed(caseOf('table'), 2));
const chair = new Stand('chair.obj', () => meshed(caseOf('chair'), 2));
const column = new Stand('column.obj', () => meshed(caseOf('cylinder'), 1));
const plate = new Stand('plate.obj', () => asDrawn(caseOf('drilled plate')));
const shelf = new Stand('cabinet.obj', () => cabinet(raw()));
const bar = new Stand('bar.obj', () => meshed(caseOf('chamfered box'), 1.5));
const cart = new Stand('wagon.obj', () => wagon(even(0.11)));

/** Pulls the side that is pressed, straight out, and says what is to be kept. */
async function pulls(hand: Hand, keep: string, ...places: readonly Place[]): Promise<void> {
  await hand.chooses('Reshape');
  await hand.takes('Move');
  await hand.drags('Pull', ...places);
  if (keep !== 'Structure') await hand.picks('Keep', keep);
}

const turns = 'faces turn by';

function edgesOfThree({ triangles }: Shape): number {
  const faces = new Map<string, number>();
  for (let corner = 0; corner < triangles.length; corner++) {
    const [v, w] = [triangles[corner]!, triangles[corner % 3 === 2 ? corner - 2 : corner + 1]!];
    const edge = `${Math.min(v, w)} ${Math.max(v, w)}`;
    faces.set(edge, (faces.get(edge) ?? 0) + 1);
  }
  return [...faces.values()].filter((count) => count === 3).length;
}

/** Sides that are pulled straight out, with what is compared in the paper: its “3D ALUP” keeps proportions. */
export const reshapedFigures: readonly Figure[] = [
  {
    id: 'column-proportions',
    of: '2023, Fig. 5',
    caption: 'A column is pulled up by its end: what keeps proportions bulges.',
    paper: 'proportions alone scale what only was to be lengthened, structure keeps its size',
    differs: 'A plain column, whose ends are held whole.',
    mesh: column.mesh,
    act: (hand) => pulls(hand, 'Proportions', [593, 106], [593, 40]),
    claims: (outcome) => expect(column.measure(outcome).rounds[0]!.ratio).toBeGreaterThan(1.03),
  },
  {
    id: 'column-structure',
    of: '2023, Fig. 5',
    caption: 'What keeps structure has the same radius everywhere.',
    paper: 'proportions alone scale what only was to be lengthened, structure keeps its size',
    mesh: column.mesh,
    act: (hand) => pulls(hand, 'Structure', [593, 106], [593, 40]),
    claims(outcome) {
      const { rounds, normalMax } = column.measure(outcome);
      expect(Math.abs(rounds[0]!.ratio - 1)).toBeLessThan(0.005);
      expect(rounds[0]!.roundness).toBeLessThan(0.002);
      expect(normalMax, turns).toBeLessThan(0.5);
    },
  },
  ...(['Edges', 'Sizes', 'Angles', 'Proportions'] as const).map(
    (keep): Figure => ({
      id: `table-${keep.toLowerCase()}`,
      of: '2023, Fig. 7',
      caption: `A table is widened by its right side. Kept: ${keep.toLowerCase()}.`,
      paper: 'all methods but the paper’s shear or swell a table',
      differs:
        'Edges is Poisson deformation, Sizes as rigid and Angles as conformal as possible, Proportions 3D ALUP.',
      mesh: table.mesh,
      act: (hand) => pulls(hand, keep, [745, 332], [800, 350], [850, 370]),
      claims: (outcome) => expect(table.measure(outcome).planeTilt, 'sides tilt by').toBeGreaterThan(1.5),
    }),
  ),
  {
    id: 'table-structure',
    of: '2023, Fig. 7',
    caption: 'A table is widened by its right side. Kept: structure.',
    paper: 'all methods but the paper’s shear or swell a table',
    mesh: table.mesh,
    act: (hand) => pulls(hand, 'Structure', [745, 332], [800, 350], [850, 370]),
    claims(outcome) {
      const { planeTilt, lineBend } = table.measure(outcome);
      expect(planeTilt, 'sides tilt by').toBeLessThan(0.5);
      expect(lineBend).toBeLessThan(0.001);
    },
  },
  {
    id: 'chair-sizes',
    of: '2023, Fig. 13',
    caption: 'A back is pulled up as rigidly as possible: the seat bulges and the legs spread.',
    paper: 'as-rigid-as-possible deformation turns surfaces, the paper’s method does not',
    differs: 'A chair instead of an espresso pot; ours on surfaces only.',
    mesh: chair.mesh,
    act: (hand) => pulls(hand, 'Sizes', [450, 152], [450, 60]),
    claims: (outcome) => expect(chair.measure(outcome).normalMean, turns).toBeGreaterThan(3),
  },
  {
    id: 'chair-structure',
    of: '2023, Fig. 13',
    caption: 'Structure is kept: the back gets longer.',
    paper: 'as-rigid-as-possible deformation turns surfaces, the paper’s method does not',
    mesh: chair.mesh,
    act: (hand) => pulls(hand, 'Structure', [450, 152], [450, 60]),
    claims: (outcome) => expect(chair.measure(outcome).normalMean, turns).toBeLessThan(1),
  },
  {
    id: 'plate-slivers',
    of: '2023, Fig. 18',
    caption: 'A plate of slivers is lengthened on even faces and comes back with its own: holes stay round.',
    paper: 'a mesh of bad triangles is reshaped on other ones, and keeps its own',
    differs: 'A drilled plate instead of an airplane, without edges of three faces.',
    mesh: plate.mesh,
    act: (hand) => pulls(hand, 'Structure', [815, 445], [850, 455], [930, 475]),
    async look(hand) {
      await hand.page.keyboard.press('3');
    },
    claims(outcome) {
      const { rounds, planeTilt, handle } = plate.measure(outcome);
      for (const { ratio, roundness } of rounds) {
        expect(Math.abs(ratio - 1)).toBeLessThan(0.02);
        expect(roundness).toBeLessThan(0.01);
      }
      expect(planeTilt, 'sides tilt by').toBeLessThan(0.1);
      expect(handle).toBeLessThan(0.001);
    },
  },
  {
    id: 'cabinet-walls',
    of: '2023, Fig. 18',
    caption:
      'Edges of three faces, where thin walls part a cabinet: it is lengthened, and the round openings stay.',
    paper: 'a mesh of bad triangles is reshaped on other ones, and keeps its own',
    mesh: shelf.mesh,
    act: (hand) => pulls(hand, 'Structure', [815, 445], [850, 455], [930, 475]),
    look: (hand) => hand.sweeps([420, 650], [505, 640]),
    claims(outcome) {
      expect(edgesOfThree(shelf.shape)).toBe(6);
      const { rounds, planeTilt, handle } = shelf.measure(outcome);
      expect(rounds).toHaveLength(2);
      for (const { ratio, roundness } of rounds) {
        expect(Math.abs(ratio - 1)).toBeLessThan(0.02);
        expect(roundness).toBeLessThan(0.01);
      }
      expect(planeTilt, 'sides tilt by').toBeLessThan(0.1);
      expect(handle).toBeLessThan(0.001);
    },
  },
  ...([true, false] as const).map(
    (isSpread): Figure => ({
      id: isSpread ? 'bar-spread' : 'bar-kinked',
      of: '2023, Fig. 21',
      caption: `The end of a bar is moved sideways, which no way of keeping structure allows. ${
        isSpread ? 'What it bends beside the end is spread.' : 'Left as solved, it kinks beside the end.'
      }`,
      paper: 'what handles bend next to them is spread over their surroundings, and they stay met',
      differs: 'The paper’s method alone, without 3D ALUP.',
      mesh: bar.mesh,
      async act(hand) {
        await hand.chooses('Reshape');
        await hand.takes('Move');
        await hand.clicksAt([815, 445]);
        await hand.keys('Move', 'gz-1');
        if (isSpread) return;
        await hand.unfolds('Solver');
        await hand.page.getByLabel('Smooth at handles').uncheck();
        await hand.rests();
      },
      claims(outcome) {
        const { normalMax, handle } = bar.measure(outcome);
        if (isSpread) expect(normalMax, turns).toBeLessThan(38);
        else expect(normalMax, turns).toBeGreaterThan(42);
        expect(handle).toBeLessThan(0.005);
      },
    }),
  ),
  {
    id: 'wagon',
    of: '2023, Fig. 19',
    caption: 'Six parts that do not touch: the body is lengthened, its wheels stay round and come along.',
    paper: 'a van of many parts is lengthened',
    differs: 'A toy of six parts.',
    mesh: cart.mesh,
    act: (hand) => pulls(hand, 'Structure', [812, 458], [860, 470], [930, 490]),
    claims(outcome) {
      const { rounds, normalMax } = cart.measure(outcome);
      expect(rounds).toHaveLength(4);
      for (const { ratio, roundness } of rounds) {
        expect(Math.abs(ratio - 1)).toBeLessThan(0.02);
        expect(roundness).toBeLessThan(0.01);
      }
      expect(normalMax, turns).toBeLessThan(1);
    },
  },
];
