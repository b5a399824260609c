import { add, dot, scale, subtract, type Vec3 } from '../../src/mesh/vectors.ts';
import type { CanvasPointer } from '../../src/viewer/canvas-tool.ts';
import type { Picking } from '../../src/viewer/picking/picking.ts';
import type { PointerWay } from './typed-transform.ts';

type Place = Pick<CanvasPointer, 'x' | 'y'>;

/** The plane through a point that faces the one who looks: a pointer moves what it has hold of along it. */
export class ViewPlane {
  readonly #picking: Picking;
  readonly #through: Vec3;
  readonly #toEye: Vec3;
  readonly #from: Vec3;

  /** @param pointer where it begins   @param through in the file's frame */
  constructor(picking: Picking, pointer: Place, through: Vec3) {
    this.#picking = picking;
    this.#through = through;
    this.#toEye = scale(picking.ray(pointer).direction, -1);
    this.#from = this.#under(pointer);
  }

  /** From where it began to where the pointer is now. */
  way(pointer: Place): PointerWay {
    return { from: this.#from, to: this.#under(pointer), toEye: this.#toEye };
  }

  /** How far the pointer has gone along a direction (unit), as it is seen; where one looks along it, wherever the pointer has gone. */
  along(pointer: Place, direction: Vec3): Vec3 {
    const { from, to, toEye } = this.way(pointer);
    const way = subtract(to, from);
    const seen = subtract(direction, scale(toEye, dot(direction, toEye)));
    const share = dot(seen, seen);
    return share < leastSeen ? way : scale(direction, dot(way, seen) / share);
  }

  #under(pointer: Place): Vec3 {
    const { origin, direction } = this.#picking.ray(pointer);
    const approach = dot(direction, this.#toEye);
    const way = dot(subtract(this.#through, origin), this.#toEye) / approach;
    return add(origin, scale(direction, way));
  }
}

/** Squared sine of the angle between the eye and a direction from which on the way along it can be told: 10°. */
const leastSeen = 0.03;
