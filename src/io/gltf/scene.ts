import type { GltfDocument, Json } from './document.ts';
import { compose, identity, type Matrix, multiply } from './matrix.ts';
import { Skins } from './skins.ts';

/** A mesh at its place in the scene. */
export interface Placement {
  /** Index into the document's meshes. */
  readonly mesh: number;
  /** From the mesh's own frame to the scene's; that of a skinned mesh is its joints', see `skins.ts`. */
  readonly toWorld: Matrix;
  readonly isSkinned: boolean;
  /** That of the node, or of the mesh; '' if they have none. */
  readonly name: string;
  readonly place: string;
}

/**
 * The meshes of the default scene, in the order of the node tree. Without scenes, all nodes; without nodes, all meshes.
 *
 * @throws malformed-file if a node is reached twice (the graph must be a forest), index-out-of-range
 */
export function placements(document: GltfDocument): Placement[] {
  const nodes = document.list(document.root, 'nodes');
  if (nodes.length === 0) {
    return document.list(document.root, 'meshes').map((_, mesh) => {
      const name = nameOf(document, mesh);
      return { mesh, toWorld: identity, isSkinned: false, name, place: `mesh ${mesh}` };
    });
  }
  const found: (Omit<Placement, 'toWorld' | 'isSkinned'> & { node: unknown; skin: unknown })[] = [];
  /** From each node's frame to the scene's. */
  const worlds = new Map<unknown, Matrix>();
  // A stack of its own: a chain of a million nodes must not end the program's.
  const stack = rootNodes(document, nodes).map((node) => ({ node, parent: identity, user: 'scene' }));
  stack.reverse();
  for (let top = stack.pop(); top; top = stack.pop()) {
    const { node, parent, user } = top;
    const json = document.element('nodes', node, user);
    const place = `node ${String(node)}`;
    if (worlds.has(node)) throw document.malformed(place, 'it stands in the scene twice, or contains itself');
    const toWorld = multiply(parent, localMatrix(document, json, place));
    worlds.set(node, toWorld);
    if (json.mesh !== undefined) {
      document.element('meshes', json.mesh, place);
      const mesh = json.mesh as number;
      found.push({ mesh, node, skin: json.skin, name: nameOf(document, mesh, json), place });
    }
    const children = document.list(json, 'children');
    for (let i = children.length - 1; i >= 0; i--)
      stack.push({ node: children[i], parent: toWorld, user: place });
  }
  const used = found.flatMap(({ skin }) => (skin === undefined ? [] : [skin]));
  const skins = new Skins(document, worlds, used);
  return found.map(({ mesh, node, skin, name, place }) => {
    const isSkinned = skin !== undefined;
    return { mesh, name, place, isSkinned, toWorld: isSkinned ? skins.toWorld(skin) : worlds.get(node)! };
  });
}

function nameOf(document: GltfDocument, mesh: number, node: Json = {}): string {
  const names = [node.name, document.element('meshes', mesh, 'scene').name];
  return names.find((name): name is string => typeof name === 'string') ?? '';
}

function rootNodes(document: GltfDocument, nodes: readonly unknown[]): unknown[] {
  const scenes = document.list(document.root, 'scenes');
  if (scenes.length > 0) {
    const scene = document.element('scenes', document.count(document.root.scene, 'scene'), 'scene');
    return [...document.list(scene, 'nodes')];
  }
  const children = new Set(
    nodes.flatMap((node, i) => [...document.list(document.record(node, `node ${i}`), 'children')]),
  );
  return nodes.map((_, i) => i).filter((i) => !children.has(i));
}

function localMatrix(document: GltfDocument, node: Json, place: string): Matrix {
  if (node.matrix !== undefined) return document.numbers(node.matrix, 16, place, identity);
  return compose(
    document.numbers(node.translation, 3, place, [0, 0, 0]),
    document.numbers(node.rotation, 4, place, [0, 0, 0, 1]),
    document.numbers(node.scale, 3, place, [1, 1, 1]),
  );
}
