import { inSavedSteps } from '../../src/inputs/fields/read-sphere-field.ts';
import { unit, type Vec3 } from '../../src/mesh/vectors.ts';
import type { SphereField } from '../../src/methods/values/sphere-field.ts';
import { type FieldBrush, FieldStroke, SphereCanvas, Stroke, unpainted } from '../../src/painting/index.ts';

/** Pixels of a painted ball from pole to pole. */
const ballHeight = 128;

/** Strokes on the ball of directions. */
export class BallBrush {
  #canvas: SphereCanvas | null = null;
  #gesture: { readonly stroke: FieldStroke<Vec3>; readonly path: Stroke; field: SphereField } | null = null;

  /** The ball as the stroke that is under way has left it; null between strokes. */
  get field(): SphereField | null {
    return this.#gesture?.field ?? null;
  }

  /** @param field what is on the ball; null where nobody has painted   @param brush its radius in radians */
  begin(field: SphereField | null, brush: FieldBrush, isMirrored: boolean): void {
    const base = field ?? evenField(unpainted);
    if (this.#canvas?.height !== base.height || !!this.#canvas.partner !== isMirrored)
      this.#canvas = new SphereCanvas(base.height, isMirrored);
    const stroke = new FieldStroke(this.#canvas, Float64Array.from(base.values), brush);
    this.#gesture = { stroke, path: new Stroke(brush.radius / 4), field: base };
  }

  /** Touches on the way to a direction. In the steps of the PNG that it is saved as, page and file are the same to the bit. */
  touch(direction: Vec3, pressure: number): void {
    const gesture = this.#gesture;
    if (!gesture) return;
    for (const point of gesture.path.to(direction)) gesture.stroke.touch(unit(point), pressure);
    gesture.field = inSavedSteps({ ...gesture.field, values: gesture.stroke.values });
  }

  /** @returns what the stroke has made of the ball */
  end(): SphereField | null {
    const { field } = this;
    this.#gesture = null;
    return field;
  }
}

/** A ball of one strength. */
export function evenField(value: number): SphereField {
  const values = new Float64Array(2 * ballHeight * ballHeight).fill(value);
  return { width: 2 * ballHeight, height: ballHeight, values };
}
