import type { Mesh } from '../../src/mesh/mesh.ts';
import { weldOf } from '../../src/mesh/weld.ts';
import { type Candidate, drawnOf, type SelectableMesh, type Selection } from '../../src/selection/index.ts';
import type { Layer } from '../../src/viewer/layers/layer.ts';
import type { Layers } from '../../src/viewer/layers/layers.ts';

/** Blue: red and orange are what is held and moved. */
const color = '#2f7de1';

/** Draws what is selected, and over it what a click would take. */
export class SelectLayers {
  readonly #layers: Layers;
  #selection: Selection | null = null;
  #candidate: Candidate | null = null;

  constructor(layers: Layers) {
    this.#layers = layers;
  }

  showSelection(surface: SelectableMesh | null, mesh: Mesh, selection: Selection | null): void {
    if (selection === this.#selection && this.#layers.names.some((name) => name.startsWith('selected')))
      return;
    this.#selection = selection;
    const drawn = surface && selection && selection.count > 0 ? drawnOf(selection, surface.topology) : null;
    this.#set('selected faces', drawn && this.#faces(mesh, drawn.faces, 0.42));
    this.#set('selected lines', drawn && this.#lines(mesh, drawn.edges, 2));
    this.#set('selected dots', drawn && this.#dots(mesh, drawn.vertices, 7));
  }

  showCandidate(mesh: Mesh, candidate: Candidate | null): void {
    if (candidate === this.#candidate) return;
    this.#candidate = candidate;
    this.#set('pointed faces', candidate && this.#faces(mesh, candidate.faces, 0.22));
    this.#set('pointed lines', candidate && this.#lines(mesh, candidate.edges, 2.5));
    const isDot = candidate?.kind === 'vertex';
    this.#set('pointed dot', isDot ? this.#dots(mesh, candidate.vertices, 10) : null);
  }

  clear(): void {
    this.#selection = this.#candidate = null;
    for (const name of names) this.#layers.set(name, null);
  }

  #set(name: (typeof names)[number], layer: Layer | null): void {
    this.#layers.set(name, layer);
  }

  #faces(mesh: Mesh, faces: Uint32Array, opacity: number): Layer | null {
    if (faces.length === 0) return null;
    const { solved, triangles } = weldOf(mesh);
    const { positionOfVertex } = weldOf(mesh);
    const welded = solved?.triangles ?? triangles;
    const corners = new Uint32Array(3 * faces.length);
    for (let i = 0; i < faces.length; i++)
      for (let k = 0; k < 3; k++) corners[3 * i + k] = positionOfVertex[welded[3 * faces[i]! + k]!]!;
    return { kind: 'faces', corners, color, opacity, depth: 'hidden-behind' };
  }

  #lines(mesh: Mesh, edges: Uint32Array, width: number): Layer | null {
    if (edges.length === 0) return null;
    return { kind: 'lines', positions: inFile(mesh, edges), color, width, depth: 'faint-behind' };
  }

  #dots(mesh: Mesh, vertices: Uint32Array, size: number): Layer | null {
    if (vertices.length === 0) return null;
    return { kind: 'points', positions: inFile(mesh, vertices), color, size, depth: 'faint-behind' };
  }
}

const names = [
  'selected faces',
  'selected lines',
  'selected dots',
  'pointed faces',
  'pointed lines',
  'pointed dot',
] as const;

function inFile(mesh: Mesh, vertices: Uint32Array): Uint32Array {
  const { positionOfVertex } = weldOf(mesh);
  return vertices.map((vertex) => positionOfVertex[vertex]!);
}
