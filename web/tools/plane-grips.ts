import { add, dot, length, scale, subtract, type Vec3 } from '../../src/mesh/vectors.ts';
import type { CanvasPointer } from '../../src/viewer/canvas-tool.ts';
import type { Interaction } from '../../src/viewer/interaction.ts';
import type { PlaneActions, PlaneSheet } from '../app/plane-actions.ts';
import type { SelectGesture } from './select-gestures.ts';

const color = '#16806f';

/** Half of an arrow, as a share of its sheet's reach. */
const arrowShare = 0.35;

/** Pixels from an arrow within which it is taken. */
const reach = { mouse: 10, pen: 12, touch: 22 } as const;

export interface PlaneParts {
  readonly interaction: Interaction;
  readonly planes: PlaneActions;
  /** Runs something before the next picture. */
  readonly soon: (run: () => void) => void;
}

/** Draws the planes that parts are held on, each with an arrow through its middle to be dragged by. */
export class PlaneGrips {
  readonly #parts: PlaneParts;
  readonly #interaction: Interaction;
  readonly #planes: PlaneActions;
  #names: string[] = [];
  #shown: readonly unknown[] = [];

  constructor(parts: PlaneParts) {
    this.#parts = parts;
    this.#interaction = parts.interaction;
    this.#planes = parts.planes;
  }

  show(): void {
    const { planes, project } = this.#planes;
    const now = [project?.mesh, ...planes];
    if (now.length === this.#shown.length && now.every((one, k) => one === this.#shown[k])) return;
    this.clear();
    this.#shown = now;
    planes.forEach((plane, index) => {
      this.#draw(this.#planes.sheetOf(plane), index);
    });
  }

  clear(): void {
    for (const name of this.#names) this.#interaction.layers.set(name, null);
    this.#names = [];
    this.#shown = [];
  }

  /** The plane whose arrow a pointer is on, taken hold of. */
  take(pointer: CanvasPointer): PlaneDrag | null {
    const { planes } = this.#planes;
    const index = planes.findIndex((plane) => this.#isOn(pointer, this.#planes.sheetOf(plane)));
    if (index < 0) return null;
    const sheet = this.#planes.sheetOf(planes[index]!);
    return new PlaneDrag(this.#parts, { index, sheet, pointer });
  }

  #draw(sheet: PlaneSheet, index: number): void {
    const { center, normal } = sheet;
    const side = 0.85 * sheet.reach;
    this.#set(`plane ${index}`, {
      ...{ kind: 'sheet', center, normal, reach: side, color, opacity: 0.2, depth: 'faint-behind' },
    });
    const [from, to] = arrowOf(sheet);
    const both = [...center, ...center];
    this.#set(`plane ${index} arrow`, {
      ...{ kind: 'arrows', from: both, to: [...from, ...to], width: 3, color, depth: 'in-front' },
    });
  }

  #set(name: string, layer: Parameters<Interaction['layers']['set']>[1]): void {
    this.#names.push(name);
    this.#interaction.layers.set(name, layer);
  }

  #isOn({ x, y, kind }: CanvasPointer, sheet: PlaneSheet): boolean {
    const [a, b] = arrowOf(sheet).map((end) => this.#interaction.picking.project(end));
    const [dx, dy] = [b!.x - a!.x, b!.y - a!.y];
    const square = dx * dx + dy * dy;
    const along = square > 0 ? ((x - a!.x) * dx + (y - a!.y) * dy) / square : 0;
    const share = Math.max(0, Math.min(1, along));
    return Math.hypot(x - a!.x - share * dx, y - a!.y - share * dy) <= reach[kind];
  }
}

function arrowOf({ center, normal, reach: size }: PlaneSheet): [Vec3, Vec3] {
  return [add(center, scale(normal, -arrowShare * size)), add(center, scale(normal, arrowShare * size))];
}

interface Taken {
  readonly index: number;
  readonly sheet: PlaneSheet;
  readonly pointer: CanvasPointer;
}

/** Moves a plane along its normal, as far as the pointer goes along the arrow. */
export class PlaneDrag implements SelectGesture {
  readonly #parts: PlaneParts;
  readonly #taken: Taken;
  readonly #from: number;
  readonly #offset: number;
  #isScheduled = false;
  #isPreviewed = false;
  #latest: CanvasPointer;

  constructor(parts: PlaneParts, taken: Taken) {
    this.#parts = parts;
    this.#taken = taken;
    this.#offset = parts.planes.planes[taken.index]!.offset;
    this.#latest = taken.pointer;
    this.#from = this.#along(taken.pointer);
  }

  /** At most one preview a picture. */
  move(pointer: CanvasPointer): void {
    this.#latest = pointer;
    if (this.#isScheduled) return;
    this.#isScheduled = true;
    this.#parts.soon(() => {
      if (!this.#isScheduled) return;
      this.#isScheduled = false;
      this.#isPreviewed = true;
      this.#parts.planes.shift(this.#taken.index, this.#offsetAt(this.#latest), false);
    });
  }

  release(pointer: CanvasPointer): void {
    this.#isScheduled = false;
    const offset = this.#offsetAt(pointer);
    if (offset === this.#offset) this.cancel();
    else this.#parts.planes.shift(this.#taken.index, offset, true);
  }

  cancel(): void {
    this.#isScheduled = false;
    if (this.#isPreviewed) this.#parts.planes.cancel();
  }

  #offsetAt(pointer: CanvasPointer): number {
    const { normal } = this.#parts.planes.planes[this.#taken.index]!;
    // The offset is in lengths of the normal, which need not be 1.
    return this.#offset + (this.#along(pointer) - this.#from) * length(normal);
  }

  /** The place on the arrow's line that is nearest to the ray through the pointer, from the middle, in file units. */
  #along(pointer: CanvasPointer): number {
    const { center, normal } = this.#taken.sheet;
    const { origin, direction } = this.#parts.interaction.picking.ray(pointer);
    const between = dot(direction, normal);
    const apart = subtract(center, origin);
    const sine = 1 - between * between;
    // A line that one looks along has no near place.
    if (sine < 1e-4) return 0;
    return (between * dot(direction, apart) - dot(normal, apart)) / sine;
  }
}
