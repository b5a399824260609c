import type { Engine } from '../../src/engine/client.ts';
import { resolveStyle } from '../../src/inputs/styles/resolve.ts';
import type { Mesh } from '../../src/mesh/mesh.ts';
import type { GaussMap } from '../../src/methods/values/gauss-map.ts';
import type { StyleEntry } from './style-gallery.ts';

/** Sees a style mesh on its way to the sphere. */
export type FlowListener = (mesh: Mesh, positions: Float64Array) => void;

/** What was seen of a flow, to be shown at a pace that eyes can follow. */
export class Film {
  #mesh: Mesh | null = null;
  readonly #pictures: Float64Array[] = [];

  readonly take: FlowListener = (mesh, positions) => {
    if (!this.#mesh) this.#pictures.push(mesh.positions);
    this.#mesh = mesh;
    this.#pictures.push(positions.slice());
  };

  /** The surface at a share of the way from 0 to 1; null if nothing was seen. */
  at(share: number): { mesh: Mesh; positions: Float64Array } | null {
    if (!this.#mesh) return null;
    const place = share * (this.#pictures.length - 1);
    const before = this.#pictures[Math.floor(place)]!;
    const after = this.#pictures[Math.ceil(place)]!;
    const part = place - Math.floor(place);
    return { mesh: this.#mesh, positions: before.map((x, i) => x + part * (after[i]! - x)) };
  }
}

/** Turns entries of the gallery into Gauss maps, each once. */
export class StyleReader {
  readonly #engine: Engine;
  readonly #maps = new Map<string, Promise<GaussMap>>();

  constructor(engine: Engine) {
    this.#engine = engine;
  }

  /** @throws WhittleError with a sentence about the style; it is tried anew the next time */
  read(entry: StyleEntry, onFlow?: FlowListener): Promise<GaussMap> {
    const known = this.#maps.get(entry.id);
    if (known) return known;
    const map = this.#readNow(entry, onFlow);
    this.#maps.set(entry.id, map);
    map.catch(() => this.#maps.delete(entry.id));
    return map;
  }

  async #readNow(entry: StyleEntry, onFlow?: FlowListener): Promise<GaussMap> {
    const subject = entry.subject();
    if ('map' in subject) return subject.map;
    const mapping = entry.group === 'shapes' ? 'closest' : 'spherical';
    return resolveStyle(subject.mesh, mapping, (mesh) => this.#flow(mesh, onFlow));
  }

  async #flow(mesh: Mesh, onFlow?: FlowListener): Promise<Float64Array> {
    const settings = { method: 'spherical', parameters: {}, start: 'rest', frames: !!onFlow } as const;
    try {
      const { positions } = await this.#engine.solve(mesh, settings, {
        onFrame: ({ positions }) => {
          if (positions) onFlow?.(mesh, positions);
        },
      });
      onFlow?.(mesh, positions);
      return positions;
    } finally {
      this.#engine.release(mesh);
    }
  }
}
