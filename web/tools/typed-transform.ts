import { type Affine, rotationAbout, scalingFrom, translation } from '../../src/mesh/affine.ts';
import { dot, scale, subtract, type Vec3 } from '../../src/mesh/vectors.ts';

export type TransformKind = 'move' | 'turn' | 'scale';

/** Where a pointer was when the keys began and is now, seen from what is transformed. */
export interface PointerWay {
  /** The point under the pointer on the plane through the pivot that faces the one who looks, at the beginning and now. */
  readonly from: Vec3;
  readonly to: Vec3;
  /** Towards the one who looks, unit. */
  readonly toEye: Vec3;
}

const kinds: Readonly<Record<string, TransformKind>> = { g: 'move', r: 'turn', s: 'scale' };
const axes: Readonly<Record<string, Vec3>> = { x: [1, 0, 0], y: [0, 1, 0], z: [0, 0, 1] };

/**
 * A transform by keys, as modelling programs have it: G moves, R turns, S scales; X, Y or Z keep it to an axis; the pointer or typed
 * digits say how far; Enter keeps it and Escape does not. Turns are typed in degrees, moves in the file's units, scales as factors.
 */
export class TypedTransform {
  readonly kind: TransformKind;
  readonly #pivot: Vec3;
  #axis: string | null = null;
  #digits = '';

  constructor(kind: TransformKind, pivot: Vec3) {
    this.kind = kind;
    this.#pivot = pivot;
  }

  /** The kind that a key asks for. */
  static kindOf(key: string): TransformKind | undefined {
    return kinds[key.toLowerCase()];
  }

  /** What there is so far, for people: “Move along x by 1.5”. */
  get sentence(): string {
    const words = { move: ['Move', 'along'], turn: ['Turn', 'about'], scale: ['Scale', 'along'] } as const;
    const [verb, way] = words[this.kind];
    const axis = this.#axis === null ? '' : ` ${way} ${this.#axis}`;
    const unit = this.kind === 'turn' ? '°' : '';
    return `${verb}${axis}${this.#digits ? ` by ${this.#digits}${unit}` : ''}`;
  }

  /** Takes a key. @returns whether it was one of its own */
  key(key: string): boolean {
    const lower = key.toLowerCase();
    if (lower in axes) this.#axis = this.#axis === lower ? null : lower;
    else if (/^[0-9.]$/.test(key)) this.#digits += key;
    else if (key === '-')
      this.#digits = this.#digits.startsWith('-') ? this.#digits.slice(1) : `-${this.#digits}`;
    else if (key === 'Backspace') this.#digits = this.#digits.slice(0, -1);
    else return false;
    return true;
  }

  /** The movement, in the file's frame. @param way null without a pointer */
  movement(way: PointerWay | null): Affine {
    const typed = Number.parseFloat(this.#digits);
    const amount = Number.isFinite(typed) ? typed : null;
    const axis = this.#axis === null ? null : axes[this.#axis]!;
    if (this.kind === 'move') return this.#move(axis, amount, way);
    if (this.kind === 'turn') return this.#turn(axis, amount, way);
    const factor = amount ?? (way ? ratio(way, this.#pivot) : 1);
    return scalingFrom(this.#pivot, factor, axis);
  }

  #move(axis: Vec3 | null, amount: number | null, way: PointerWay | null): Affine {
    // Without an axis a number is along the first, as there has to be one.
    if (amount !== null) return translation(scale(axis ?? [1, 0, 0], amount));
    if (!way) return translation([0, 0, 0]);
    const by = subtract(way.to, way.from);
    return translation(axis ? scale(axis, alongAxis(by, axis, way.toEye)) : by);
  }

  #turn(axis: Vec3 | null, amount: number | null, way: PointerWay | null): Affine {
    const about = axis ?? way?.toEye ?? [0, 0, 1];
    if (amount !== null) return rotationAbout(this.#pivot, about, (amount * Math.PI) / 180);
    if (!way) return translation([0, 0, 0]);
    const seen = angleBetween(subtract(way.from, this.#pivot), subtract(way.to, this.#pivot), way.toEye);
    // Seen from behind the axis, the same turn of the hand goes the other way.
    return rotationAbout(this.#pivot, about, dot(about, way.toEye) < 0 ? -seen : seen);
  }
}

/** How far along an axis goes what is seen to move by `by`. */
function alongAxis(by: Vec3, axis: Vec3, toEye: Vec3): number {
  const seen = subtract(axis, scale(toEye, dot(axis, toEye)));
  // An axis that is looked along cannot be told from its point.
  return dot(by, seen) / Math.max(0.04, dot(seen, seen));
}

function ratio({ from, to }: PointerWay, pivot: Vec3): number {
  const before = Math.hypot(...subtract(from, pivot));
  return before > 0 ? Math.hypot(...subtract(to, pivot)) / before : 1;
}

/** Of two directions across an axis, counter-clockwise seen from its tip, in radians. */
function angleBetween(a: Vec3, b: Vec3, axis: Vec3): number {
  const sine =
    axis[0] * (a[1] * b[2] - a[2] * b[1]) +
    axis[1] * (a[2] * b[0] - a[0] * b[2]) +
    axis[2] * (a[0] * b[1] - a[1] * b[0]);
  return Math.atan2(sine, dot(a, b));
}
