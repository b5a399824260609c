import {
  alone,
  discAround,
  type MirrorMap,
  otherEnd,
  placeOf,
  type SelectableMesh,
  type SurfacePoint,
} from '../selection/index.ts';
import type { FieldCanvas } from './canvas.ts';

/**
 * The welded vertices of a mesh under a brush. It reaches what hangs together with the face that it touches within its ball: an
 * ear that lies on a cheek is not painted through.
 */
export class SurfaceCanvas implements FieldCanvas<SurfacePoint> {
  readonly surface: SelectableMesh;
  readonly partner?: (place: number) => number | undefined;

  /** @param mirror what is painted on one side of it is painted on the other */
  constructor(surface: SelectableMesh, mirror: MirrorMap | null = null) {
    this.surface = surface;
    if (mirror) {
      this.partner = (place) => {
        const other = mirror.partner[place]!;
        return other === alone ? undefined : other;
      };
    }
  }

  get count(): number {
    return this.surface.topology.vertices;
  }

  readonly around = (
    point: SurfacePoint,
    radius: number,
    visit: (place: number, away: number) => void,
  ): void => {
    const { places } = this.surface;
    const [x, y, z] = placeOf(this.surface, point);
    for (const vertex of discAround(this.surface, point, radius)) {
      const [dx, dy, dz] = [
        places[3 * vertex]! - x,
        places[3 * vertex + 1]! - y,
        places[3 * vertex + 2]! - z,
      ];
      visit(vertex, Math.sqrt(dx * dx + dy * dy + dz * dz));
    }
  };

  readonly neighbours = (place: number, visit: (neighbour: number) => void): void => {
    const { topology } = this.surface;
    for (let i = topology.aroundStart[place]!; i < topology.aroundStart[place + 1]!; i++)
      visit(otherEnd(topology, topology.edgesAround[i]!, place));
  };
}
