import type { Mesh } from '../../src/mesh/mesh.ts';
import type { FlowListener } from '../../src/recipe/index.ts';

/** What was seen of a flow to the sphere, to be shown at a pace that eyes can follow. */
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
