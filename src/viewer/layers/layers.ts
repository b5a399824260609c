import type { Surface } from '../surface.ts';
import type { Viewer } from '../viewer.ts';
import { drawArrows } from './arrows.ts';
import { drawFaces, drawSheet } from './faces.ts';
import type { DrawnLayer, Layer } from './layer.ts';
import { drawLines } from './lines.ts';
import { drawPoints } from './points.ts';

/** What tools draw over the mesh, by names of their choice. Another mesh takes all of it away. */
export class Layers {
  readonly #viewer: Viewer;
  /** By name; each with the number of drawings before it. */
  readonly #drawn = new Map<string, { layer: Layer; drawn: DrawnLayer; since: number }>();
  /**
   * What is drawn no more, each with the number of drawings with it. It is freed once another picture has been drawn: a program that
   * no material needs is forgotten, and to link it anew for the layer that comes in its place takes longer than the picture.
   */
  readonly #retired: { drawn: DrawnLayer; until: number }[] = [];
  readonly #unlisten: () => void;

  constructor(viewer: Viewer) {
    this.#viewer = viewer;
    this.#unlisten = viewer.onShape((change) => {
      const { surface } = viewer.space;
      if (change === 'mesh' || !surface) this.clear();
      else for (const { drawn } of this.#drawn.values()) drawn.follow?.(surface);
    });
  }

  /** Draws a layer in place of the one of that name; null takes it away. The same object again changes nothing. */
  set(name: string, layer: Layer | null): void {
    const present = this.#drawn.get(name);
    if (present?.layer === layer || (!present && !layer)) return;
    if (present) this.#retire(name, present);
    const { surface, overlay } = this.#viewer.space;
    if (layer && surface) {
      const drawn = draw(layer, surface);
      const { clientWidth, clientHeight } = this.#viewer.canvas;
      drawn.resize?.(clientWidth, clientHeight);
      overlay.add(drawn.object);
      this.#drawn.set(name, { layer, drawn, since: this.#viewer.drawings });
    }
    this.#free(this.#viewer.drawings);
    this.#viewer.invalidate();
  }

  /** The names of what is drawn. */
  get names(): readonly string[] {
    return [...this.#drawn.keys()];
  }

  clear(): void {
    for (const [name, present] of this.#drawn) this.#retire(name, present);
    this.#free(Number.POSITIVE_INFINITY);
  }

  resize(width: number, height: number): void {
    for (const { drawn } of this.#drawn.values()) drawn.resize?.(width, height);
  }

  dispose(): void {
    this.#unlisten();
    this.clear();
  }

  #retire(name: string, { drawn, since }: { drawn: DrawnLayer; since: number }): void {
    drawn.object.removeFromParent();
    this.#drawn.delete(name);
    const until = this.#viewer.drawings;
    if (since < until) this.#retired.push({ drawn, until });
    else drawn.dispose();
  }

  /** Frees what was retired before so many drawings; the oldest stand first. */
  #free(drawings: number): void {
    while (this.#retired.length > 0 && this.#retired[0]!.until < drawings)
      this.#retired.shift()!.drawn.dispose();
  }
}

function draw(layer: Layer, surface: Surface): DrawnLayer {
  switch (layer.kind) {
    case 'points':
      return drawPoints(layer, surface);
    case 'lines':
      return drawLines(layer, surface);
    case 'faces':
      return drawFaces(layer, surface);
    case 'arrows':
      return drawArrows(layer, surface);
    case 'sheet':
      return drawSheet(layer, surface);
  }
}
