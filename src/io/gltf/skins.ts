import { Accessor } from './accessor.ts';
import type { GltfDocument, Json } from './document.ts';
import { identity, type Matrix, multiply } from './matrix.ts';

/** A joint of a skin: a node, and what takes a vertex from the mesh's own frame to the joint's. */
interface Joint {
  readonly node: unknown;
  readonly inverseBind: Matrix;
}

/**
 * Where skinned meshes stand. The transform of a skinned mesh's own node does not count; each of its vertices follows its joints.
 * One matrix has to do for all of them, so that the file can be given back: that of one joint, the same for all skins that have
 * it, so that parts that meet in the bind pose meet here too. Where the joints are in their bind pose all of them agree.
 */
export class Skins {
  readonly #document: GltfDocument;
  /** From each node's frame to the scene's. */
  readonly #worlds: ReadonlyMap<unknown, Matrix>;
  readonly #joints = new Map<unknown, readonly Joint[]>();
  /** Places of the joints' nodes in their order, those of most skins first. */
  readonly #ranks: ReadonlyMap<unknown, number>;
  /** Matrices given out so far: of equal ones but for rounding, the first serves. */
  readonly #given: Matrix[] = [identity];

  /** @param skins indices of the skins that the scene uses */
  constructor(document: GltfDocument, worlds: ReadonlyMap<unknown, Matrix>, skins: Iterable<unknown>) {
    this.#document = document;
    this.#worlds = worlds;
    for (const skin of skins) this.#joints.set(skin, this.#jointsOf(skin));
    this.#ranks = byUsers([...this.#joints.values()]);
  }

  /** From the own frame of a mesh with this skin to the scene's. */
  toWorld(skin: unknown): Matrix {
    const joint = this.#reference(this.#joints.get(skin) ?? []);
    if (!joint) return identity;
    const matrix = multiply(this.#worlds.get(joint.node)!, joint.inverseBind);
    const known = this.#given.find((given) => isNear(given, matrix));
    if (!known) this.#given.push(matrix);
    return known ?? matrix;
  }

  /** The joint of a skin that most skins have; of several the one that came first. */
  #reference(joints: readonly Joint[]): Joint | undefined {
    let best: Joint | undefined;
    const rank = (joint: Joint) => this.#ranks.get(joint.node)!;
    for (const joint of joints) if (!best || rank(joint) < rank(best)) best = joint;
    return best;
  }

  /** A skin that cannot be understood has none: its mesh is taken in its own frame. */
  #jointsOf(skin: unknown): readonly Joint[] {
    const document = this.#document;
    try {
      const json = document.element('skins', skin, 'node');
      const binds = this.#inverseBinds(json);
      const joints = document
        .list(json, 'joints')
        .map((node, i) => ({ node, inverseBind: binds?.[i] ?? identity }));
      return joints.filter(({ node }) => this.#worlds.has(node));
    } catch {
      return [];
    }
  }

  #inverseBinds({ inverseBindMatrices }: Json): Matrix[] | undefined {
    if (inverseBindMatrices === undefined) return undefined;
    const accessor = new Accessor(this.#document, inverseBindMatrices, 'skin');
    const values = accessor.read();
    const areMatrices = accessor.components === 16 && values.every(Number.isFinite);
    return areMatrices
      ? Array.from({ length: accessor.count }, (_, i) => [...values.subarray(16 * i, 16 * i + 16)])
      : undefined;
  }
}

function byUsers(skins: readonly (readonly Joint[])[]): Map<unknown, number> {
  const users = new Map<unknown, number>();
  for (const joints of skins)
    for (const node of new Set(joints.map((joint) => joint.node)))
      users.set(node, (users.get(node) ?? 0) + 1);
  // Sorting is stable: of equals the first stays first.
  return new Map([...users].sort((a, b) => b[1] - a[1]).map(([node], rank) => [node, rank]));
}

/** Whether two matrices are the same but for the rounding of a product. */
function isNear(a: Matrix, b: Matrix): boolean {
  const size = Math.max(...a.map(Math.abs), ...b.map(Math.abs));
  return a.every((value, i) => Math.abs(value - b[i]) <= 1e-5 * size);
}
