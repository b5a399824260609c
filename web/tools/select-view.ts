import type { Mesh } from '../../src/mesh/mesh.ts';
import { weldOf } from '../../src/mesh/weld.ts';
import {
  type Aim,
  type Candidate,
  candidateAt,
  discAround,
  type ScreenPoint,
  type ScreenShape,
  type SelectableMesh,
  type Selection,
} from '../../src/selection/index.ts';
import type { CanvasPointer } from '../../src/viewer/canvas-tool.ts';
import type { Interaction } from '../../src/viewer/interaction.ts';
import type { Selecting } from '../app/selecting.ts';
import { aimAt, reachOf } from './aim.ts';
import { ScreenMap } from './screen-map.ts';
import type { Seen } from './seen.ts';
import type { SelectInk } from './select-ink.ts';

type Place = Pick<CanvasPointer, 'x' | 'y'>;

export interface SelectViewParts {
  readonly interaction: Interaction;
  readonly selecting: Selecting;
  readonly ink: SelectInk;
  readonly seen: Seen;
}

export interface SelectViewOptions {
  readonly mesh: Mesh;
  readonly surface: SelectableMesh;
  /** What is hidden is taken too. */
  readonly through: boolean;
  /** Radius of the brush in CSS pixels. */
  readonly brush: number;
}

/** What can be seen of the mesh, and taken, from where one looks at it during one gesture. */
export class SelectView {
  readonly #parts: SelectViewParts;
  readonly #surface: SelectableMesh;
  readonly #map: ScreenMap;
  readonly #takesHidden: boolean;
  /** Radius of the brush in CSS pixels. */
  readonly brush: number;

  constructor(parts: SelectViewParts, { mesh, surface, through, brush }: SelectViewOptions) {
    this.#parts = parts;
    this.#surface = surface;
    this.#map = new ScreenMap(parts.interaction.viewer, weldOf(mesh).positionOfVertex);
    this.#takesHidden = through;
    this.brush = brush;
  }

  /** What a click would take; null beside the mesh. */
  candidate(pointer: CanvasPointer, wholePart = false): Candidate | null {
    const aim = this.#aim(pointer, reachOf[pointer.kind]);
    if (!aim) return null;
    return candidateAt(this.#surface, aim, { oneVertex: pointer.alt, wholePart, spot: this.#radius(aim) });
  }

  /** The vertices under the brush; none beside the mesh. */
  disc(place: Place): Uint32Array {
    const aim = this.#aim(place, 0);
    if (!aim) return new Uint32Array(0);
    const found = discAround(this.#surface, aim, this.#radius(aim));
    if (this.#takesHidden) return found;
    const { sees } = this.seen();
    return found.filter((vertex) => sees(vertex));
  }

  /** Where everything is on the canvas, and what of it is not hidden. */
  seen(): { shape: ScreenShape; sees: (vertex: number) => boolean } {
    if (this.#takesHidden) return { shape: this.#map.shape(), sees: () => true };
    const { shape, visibility } = this.#parts.seen.of(this.#map, this.#surface);
    return { shape, sees: (vertex) => visibility.sees(vertex) };
  }

  /** Someone is about to brush. */
  prepare(): void {
    if (!this.#takesHidden) this.#parts.seen.prepare(this.#map, this.#surface);
  }

  put(selection: Selection): void {
    this.#parts.selecting.put(selection);
  }

  draw(outline: readonly ScreenPoint[]): void {
    this.#parts.ink.outline(outline);
  }

  #aim(place: Place, within: number): Aim | null {
    const hit = this.#parts.interaction.picking.pick(place);
    return hit && aimAt(hit, place, this.#map, within);
  }

  #radius({ face }: Aim): number {
    return this.#map.unitsAt(this.#surface.topology.triangles[3 * face]!, this.brush);
  }
}
