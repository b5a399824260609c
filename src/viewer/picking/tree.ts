import { BufferAttribute, BufferGeometry } from 'three';
import { MeshBVH } from 'three-mesh-bvh';

/** A tree of boxes over triangles as it goes between threads: its boxes, and the triangles in the order of its leaves. */
export interface PackedTree {
  readonly roots: ArrayBuffer[];
  readonly order: Uint32Array<ArrayBuffer> | Uint16Array<ArrayBuffer> | null;
}

/** What the tree's thread is asked. */
export type TreeRequest =
  | {
      readonly type: 'build';
      readonly turn: number;
      /** #P×3. */
      readonly positions: Float32Array<ArrayBuffer>;
      /** #F×3. */
      readonly triangles: Uint32Array<ArrayBuffer>;
    }
  | { readonly type: 'refit'; readonly turn: number; readonly positions: Float32Array<ArrayBuffer> };

export interface TreeAnswer {
  readonly turn: number;
  readonly tree: PackedTree;
}

/** Builds trees, and fits the latest to other positions of the same triangles: boxes change, their order does not. */
export class TreeKeeper {
  #tree: MeshBVH | null = null;

  answer(request: TreeRequest): TreeAnswer {
    if (request.type === 'build') {
      this.#tree = buildTree(request.positions, request.triangles);
    } else if (this.#tree) {
      const { position } = this.#tree.geometry.attributes;
      (position as BufferAttribute).array = request.positions;
      this.#tree.refit();
    }
    return { turn: request.turn, tree: pack(this.#tree!) };
  }
}

/** @param positions #P×3   @param triangles #F×3; neither is changed */
export function buildTree(positions: Float32Array, triangles: Uint32Array): MeshBVH {
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(positions, 3));
  geometry.setIndex(new BufferAttribute(triangles, 1));
  return new MeshBVH(geometry, { indirect: true });
}

/** @param geometry with the triangles that the tree was built for, in any of their positions */
export function unpack({ roots, order }: PackedTree, geometry: BufferGeometry): MeshBVH {
  const data = { version: 1, roots, index: null, indirectBuffer: order };
  return MeshBVH.deserialize(data as unknown as Parameters<typeof MeshBVH.deserialize>[0], geometry, {
    setIndex: false,
  });
}

function pack(tree: MeshBVH): PackedTree {
  const { roots, indirectBuffer } = MeshBVH.serialize(tree) as unknown as {
    roots: ArrayBuffer[];
    indirectBuffer: PackedTree['order'];
  };
  return { roots, order: indirectBuffer };
}
