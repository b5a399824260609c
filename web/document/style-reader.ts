import type { Engine } from '../../src/engine/client.ts';
import type { Mesh } from '../../src/mesh/mesh.ts';
import type { GaussMap } from '../../src/methods/gauss-map.ts';
import { normalsOfConvex } from '../../src/styles/convex-normals.ts';
import { refined } from '../../src/styles/refined.ts';
import { sphereNormals } from '../../src/styles/sphere-normals.ts';
import type { StyleEntry } from './style-gallery.ts';

/** Sees a style mesh on its way to the sphere. */
export type FlowListener = (mesh: Mesh, positions: Float64Array) => Promise<void>;

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
    if (entry.group === 'shapes') return { kind: 'closest', normals: normalsOfConvex(subject.mesh) };
    return this.#throughSphere(subject.mesh, onFlow);
  }

  async #throughSphere(style: Mesh, onFlow?: FlowListener): Promise<GaussMap> {
    const mesh = refined(style);
    const settings = { method: 'spherical', parameters: {}, start: 'rest', frames: !!onFlow } as const;
    try {
      const { positions } = await this.#engine.solve(mesh, settings, {
        onFrame: async ({ positions }) => {
          if (positions) await onFlow?.(mesh, positions);
        },
      });
      const { points, triangles, faceNormals } = sphereNormals(mesh, positions);
      return { kind: 'sphere', points, triangles, normals: faceNormals, per: 'face' };
    } finally {
      this.#engine.release(mesh);
    }
  }
}
