import type { Mesh } from '../../src/mesh/mesh.ts';
import { type Candidate, drawnOf, type SelectableMesh, type Selection } from '../../src/selection/index.ts';
import type { Layers } from '../../src/viewer/layers/layers.ts';
import { CandidateLayers, dotsLayer, edgesLayer, facesLayer } from './candidate-layers.ts';

/** Blue: red and orange are what is held and moved. */
const color = '#2f7de1';

/** Draws what is selected, and over it what a click would take. */
export class SelectLayers {
  readonly #layers: Layers;
  readonly #pointed: CandidateLayers;
  #selection: Selection | null = null;

  constructor(layers: Layers) {
    this.#layers = layers;
    this.#pointed = new CandidateLayers(layers);
  }

  showSelection(surface: SelectableMesh | null, mesh: Mesh, selection: Selection | null): void {
    if (selection === this.#selection && this.#layers.names.some((name) => name.startsWith('selected')))
      return;
    this.#selection = selection;
    const drawn = surface && selection && selection.count > 0 ? drawnOf(selection, surface.topology) : null;
    this.#layers.set('selected faces', drawn && facesLayer(mesh, drawn.faces, color, 0.42));
    this.#layers.set('selected lines', drawn && edgesLayer(mesh, drawn.edges, color, 2));
    this.#layers.set('selected dots', drawn && dotsLayer(mesh, drawn.vertices, color, 7));
  }

  showCandidate(mesh: Mesh, candidate: Candidate | null): void {
    this.#pointed.show(mesh, candidate, color);
  }

  clear(): void {
    this.#selection = null;
    this.#pointed.clear();
    for (const name of ['selected faces', 'selected lines', 'selected dots']) this.#layers.set(name, null);
  }
}
