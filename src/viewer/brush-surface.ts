import { BufferAttribute, BufferGeometry, DoubleSide, Ray, Sphere, Vector3 } from 'three';
import { INTERSECTED, MeshBVH, NOT_INTERSECTED } from 'three-mesh-bvh';
import { distance, row, type Vec3 } from '../mesh/vectors.ts';

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
  readonly around = (center: Vec3, radius: number, visit: (vertex: number, away: number) => void): void => {
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
  };
}
