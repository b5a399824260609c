import {
  boxRegion,
  type Combination,
  combined,
  nothing,
  type ScreenPoint,
  type Selection,
  verticesInside,
} from '../../src/selection/index.ts';
import type { CanvasPointer } from '../../src/viewer/canvas-tool.ts';
import type { SelectView } from './select-view.ts';

/** What is under way between a press and its release. */
export interface SelectGesture {
  move(pointer: CanvasPointer): void;
  release(pointer: CanvasPointer): void;
}

export const pointOf = ({ x, y }: CanvasPointer): ScreenPoint => [x, y];

const distanceOf = (a: ScreenPoint, b: ScreenPoint): number => Math.hypot(a[0] - b[0], a[1] - b[1]);

/** A pointer that moved further was not meant as a click, in CSS pixels. */
const still = { mouse: 4, pen: 6, touch: 10 } as const;

export function isStill(from: CanvasPointer, to: CanvasPointer): boolean {
  return distanceOf(pointOf(from), pointOf(to)) <= still[to.kind];
}

/** Takes what is under the brush as it goes. */
export class BrushStroke implements SelectGesture {
  readonly #view: SelectView;
  readonly #how: Combination;
  #last: ScreenPoint | null = null;
  #selection: Selection;

  constructor(view: SelectView, before: Selection, how: Combination) {
    this.#view = view;
    this.#how = how === 'remove' ? 'remove' : 'add';
    this.#selection = how === 'replace' ? nothing(before.marks.length) : before;
  }

  /** Dabs lie so close that no gap is left between them, however fast the pointer is. */
  move(pointer: CanvasPointer): void {
    const to = pointOf(pointer);
    const from = this.#last ?? to;
    const steps = Math.max(1, Math.ceil(distanceOf(from, to) / (this.#view.brush / 2)));
    const found: Uint32Array[] = [];
    for (let step = this.#last ? 1 : steps; step <= steps; step++) {
      const share = step / steps;
      const x = from[0] + share * (to[0] - from[0]);
      const y = from[1] + share * (to[1] - from[1]);
      found.push(this.#view.disc({ x, y }));
    }
    this.#last = to;
    for (const vertices of found) this.#selection = combined(this.#selection, vertices, this.#how);
    this.#view.put(this.#selection);
  }

  release(): void {}
}

/** Takes what lies inside a line that a person draws around it, or inside a frame. */
export class Outline implements SelectGesture {
  readonly #view: SelectView;
  readonly #before: Selection;
  readonly #how: Combination;
  readonly #isBox: boolean;
  readonly #points: ScreenPoint[];

  constructor(
    view: SelectView,
    before: Selection,
    how: Combination,
    { from, isBox }: { from: CanvasPointer; isBox: boolean },
  ) {
    this.#view = view;
    this.#before = before;
    this.#how = how;
    this.#isBox = isBox;
    this.#points = [pointOf(from)];
  }

  move(pointer: CanvasPointer): void {
    const to = pointOf(pointer);
    if (!this.#isBox && distanceOf(this.#points.at(-1)!, to) >= 2) this.#points.push(to);
    this.#view.draw(this.#region(to).outline);
  }

  release(pointer: CanvasPointer): void {
    this.#view.draw([]);
    const { shape, sees } = this.#view.seen();
    const vertices = verticesInside(this.#region(pointOf(pointer)), shape.places, sees);
    this.#view.put(combined(this.#before, vertices, this.#how));
  }

  #region(to: ScreenPoint) {
    return this.#isBox ? boxRegion(this.#points[0]!, to) : { outline: [...this.#points, to] };
  }
}
