import { BufferAttribute, BufferGeometry, DoubleSide, Ray, Sphere, Vector3 } from 'three';
import { INTERSECTED, MeshBVH, NOT_INTERSECTED } from 'three-mesh-bvh';
import { between, distance, row, type Vec3 } from '../mesh/vectors.ts';

/** The end of a brush that touches a surface. */
export interface BrushTip {
  /** In units of the surface. */
  readonly radius: number;
  /** 0 fades from the middle on, 1 is full up to the rim. */
  readonly hardness: number;
}

/** How much a brush gives at a distance from its middle: 1 inside its hard core, smoothly down to 0 at its radius. */
export function falloff(away: number, { radius, hardness }: BrushTip): number {
  const core = radius * Math.min(0.999, Math.max(0, hardness));
  if (away <= core) return 1;
  if (away >= radius) return 0;
  const t = (radius - away) / (radius - core);
  return t * t * (3 - 2 * t);
}

/** Turns the points where a pointer was seen into touches that overlap, however quickly it moved. */
export class Stroke {
  readonly #spacing: number;
  #last: Vec3 | null = null;

  /** @param spacing most there may be between two touches */
  constructor(spacing: number) {
    this.#spacing = spacing;
  }

  /** The touches that lead to a point, itself the last. */
  to(point: Vec3): Vec3[] {
    const from = this.#last ?? point;
    this.#last = point;
    const steps = Math.max(1, Math.ceil(distance(from, point) / this.#spacing));
    return Array.from({ length: steps }, (_, k) => between(from, point, (k + 1) / steps));
  }
}

/**
 * A stroke's effect on the vertices of a surface. A vertex that is touched again and again within one stroke gets the most
 * of what the touches give, not their sum: a stroke over itself is no darker.
 */
export class Coverage {
  readonly #surface: BrushSurface;
  /** #V, 0 to 1. */
  readonly share: Float64Array<ArrayBuffer>;

  constructor(surface: BrushSurface) {
    this.#surface = surface;
    this.share = new Float64Array(surface.vertices);
  }

  /** @returns vertices whose share grew */
  touch(point: Vec3, tip: BrushTip): number[] {
    const grown: number[] = [];
    this.#surface.around(point, tip.radius, (vertex, away) => {
      const share = falloff(away, tip);
      if (share <= this.share[vertex]!) return;
      this.share[vertex] = share;
      grown.push(vertex);
    });
    return grown;
  }
}

/** What a ray meets first. */
export interface Hit {
  readonly point: Vec3;
  readonly face: number;
}

/** A surface that can be pointed at and brushed: picking and neighbourhoods by a tree of boxes. */
export class BrushSurface {
  readonly vertices: number;
  readonly #positions: ArrayLike<number>;
  readonly #triangles: ArrayLike<number>;
  readonly #tree: MeshBVH;
  /** The turn in which a vertex was last visited, so that it is visited once. */
  readonly #seen: Uint32Array;
  #turn = 0;

  /** @param positions #V×3   @param triangles #F×3; neither is changed */
  constructor(positions: ArrayLike<number>, triangles: ArrayLike<number>) {
    this.vertices = positions.length / 3;
    this.#positions = positions;
    this.#triangles = triangles;
    this.#seen = new Uint32Array(this.vertices);
    const geometry = new BufferGeometry();
    geometry.setAttribute('position', new BufferAttribute(Float32Array.from(positions), 3));
    geometry.setIndex(new BufferAttribute(Uint32Array.from(triangles), 1));
    this.#tree = new MeshBVH(geometry, { indirect: true });
  }

  hit(origin: Vec3, direction: Vec3): Hit | null {
    const ray = new Ray(new Vector3(...origin), new Vector3(...direction));
    const found = this.#tree.raycastFirst(ray, DoubleSide);
    if (!found) return null;
    return { point: found.point.toArray() as Vec3, face: found.faceIndex ?? 0 };
  }

  /** Visits each vertex of the faces that a ball reaches and that is itself in the ball, once, with its distance. */
  around(center: Vec3, radius: number, visit: (vertex: number, away: number) => void): void {
    const turn = ++this.#turn;
    const ball = new Sphere(new Vector3(...center), radius);
    this.#tree.shapecast({
      intersectsBounds: (box) => (box.intersectsSphere(ball) ? INTERSECTED : NOT_INTERSECTED),
      intersectsTriangle: (_, face) => {
        for (let corner = 3 * face; corner < 3 * face + 3; corner++) {
          const vertex = this.#triangles[corner]!;
          if (this.#seen[vertex] === turn) continue;
          this.#seen[vertex] = turn;
          const away = distance(row(this.#positions, vertex), center);
          if (away < radius) visit(vertex, away);
        }
        return false;
      },
    });
  }
}
