import type { Mesh } from '../../src/mesh/mesh.ts';
import { weldOf } from '../../src/mesh/weld.ts';
import type { Candidate } from '../../src/selection/index.ts';
import type { Layer } from '../../src/viewer/layers/layer.ts';
import type { Layers } from '../../src/viewer/layers/layers.ts';

/** Faces that the solver takes, tinted. */
export function facesLayer(mesh: Mesh, faces: Uint32Array, color: string, opacity: number): Layer | null {
  if (faces.length === 0) return null;
  const { solved, triangles, positionOfVertex } = weldOf(mesh);
  const welded = solved?.triangles ?? triangles;
  const corners = new Uint32Array(3 * faces.length);
  for (let i = 0; i < faces.length; i++)
    for (let k = 0; k < 3; k++) corners[3 * i + k] = positionOfVertex[welded[3 * faces[i]! + k]!]!;
  return { kind: 'faces', corners, color, opacity, depth: 'hidden-behind' };
}

/** @param edges #×2 welded vertices */
export function edgesLayer(mesh: Mesh, edges: Uint32Array, color: string, width: number): Layer | null {
  if (edges.length === 0) return null;
  return { kind: 'lines', positions: inFile(mesh, edges), color, width, depth: 'faint-behind' };
}

/** @param vertices welded */
export function dotsLayer(mesh: Mesh, vertices: Uint32Array, color: string, size: number): Layer | null {
  if (vertices.length === 0) return null;
  return { kind: 'points', positions: inFile(mesh, vertices), color, size, depth: 'faint-behind' };
}

/** Shows what a click or a press would take. */
export class CandidateLayers {
  readonly #layers: Layers;
  #shown: readonly unknown[] = [null];

  constructor(layers: Layers) {
    this.#layers = layers;
  }

  show(mesh: Mesh, candidate: Candidate | null, color: string): void {
    const now = [candidate, candidate && color];
    if (now.every((value, k) => value === this.#shown[k])) return;
    this.#shown = now;
    this.#layers.set('pointed faces', candidate && facesLayer(mesh, candidate.faces, color, 0.22));
    this.#layers.set('pointed lines', candidate && edgesLayer(mesh, candidate.edges, color, 2.5));
    const isDot = candidate?.kind === 'vertex';
    this.#layers.set('pointed dot', isDot ? dotsLayer(mesh, candidate.vertices, color, 10) : null);
  }

  clear(): void {
    this.#shown = [null];
    for (const name of ['pointed faces', 'pointed lines', 'pointed dot']) this.#layers.set(name, null);
  }
}

function inFile(mesh: Mesh, vertices: Uint32Array): Uint32Array {
  const { positionOfVertex } = weldOf(mesh);
  return vertices.map((vertex) => positionOfVertex[vertex]!);
}
