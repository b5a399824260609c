import { edgesOf } from '../../src/editor/chains.ts';
import type { Mesh } from '../../src/mesh/mesh.ts';
import type { ChainRole, Chains } from '../../src/methods/values/chains.ts';
import { type Line, type SelectableMesh, sharpEdges } from '../../src/selection/index.ts';
import type { Layer } from '../../src/viewer/layers/layer.ts';
import type { Layers } from '../../src/viewer/layers/layers.ts';
import { edgesLayer } from './candidate-layers.ts';

/** What lines are drawn in, on the mesh and beside their names. */
export const lineColors: Readonly<Record<ChainRole, string>> = {
  crease: '#7b3fe4',
  smooth: '#0c8f7d',
  straight: '#2f7de1',
};

/** Those that nobody has marked. */
export const plainColor = '#7d7168';

export interface MarkedLines {
  readonly role: ChainRole;
  readonly chains: Chains;
}

/** Draws lines along edges: those of the shape, those that are marked, and what a click would take. */
export class LineLayers {
  readonly #layers: Layers;
  #surface: SelectableMesh | null = null;
  readonly #marked = new Map<ChainRole, Chains>();
  #line: Line | null = null;

  constructor(layers: Layers) {
    this.#layers = layers;
  }

  show(surface: SelectableMesh | null, mesh: Mesh | null, marked: readonly MarkedLines[]): void {
    const isNew = !this.#layers.names.includes('sharp lines');
    if (surface !== this.#surface || isNew) {
      this.#surface = surface;
      const edges = surface && mesh && edgesLayer(mesh, sharpEdges(surface), plainColor, 1.2);
      this.#layers.set('sharp lines', edges);
    }
    for (const { role, chains } of marked) {
      const name = `marked ${role}`;
      if (chains === this.#marked.get(role) && (chains.length === 0 || this.#layers.names.includes(name)))
        continue;
      this.#marked.set(role, chains);
      this.#layers.set(name, drawn(chains, lineColors[role], 4));
    }
  }

  /** What a stroke that is under way has met. */
  stroke(lines: MarkedLines | null): void {
    this.#layers.set('met lines', lines && drawn(lines.chains, lineColors[lines.role], 3));
  }

  point(mesh: Mesh | null, line: Line | null, role: ChainRole): void {
    if (!line && !this.#line) return;
    this.#line = line;
    const { vertices = [] } = line ?? {};
    const edges = Uint32Array.from(edgesOf(vertices).flat());
    this.#layers.set('pointed lines', mesh && edgesLayer(mesh, edges, lineColors[role], 2.5));
  }

  clear(): void {
    this.#surface = this.#line = null;
    this.#marked.clear();
    for (const name of this.#layers.names)
      if (name.endsWith(' lines') || name.startsWith('marked ')) this.#layers.set(name, null);
  }
}

function drawn(chains: Chains, color: string, width: number): Layer | null {
  const positions = chains.flatMap((chain) => edgesOf(chain).flat());
  if (positions.length === 0) return null;
  return { kind: 'lines', positions, color, width, depth: 'faint-behind' };
}
