import { centerIn, type HandleGroup, targetCenter } from '../../src/editor/handle-groups.ts';
import { type Project, restShapeOf } from '../../src/editor/project.ts';
import type { Mesh } from '../../src/mesh/mesh.ts';
import { weldOf } from '../../src/mesh/weld.ts';
import type { Handles } from '../../src/methods/values/handles.ts';
import {
  type Candidate,
  combined,
  drawnOf,
  nothing,
  type SelectableMesh,
} from '../../src/selection/index.ts';
import type { Layer } from '../../src/viewer/layers/layer.ts';
import type { Layers } from '../../src/viewer/layers/layers.ts';
import { CandidateLayers, dotsLayer, facesLayer } from './candidate-layers.ts';

const red = '#d8342a';
const orange = '#f0891c';
const grey = '#8a8078';

/** What pressing on the mesh does. */
export type MoveMode = 'pull' | 'hold' | 'let-go';

const hoverColors: Readonly<Record<MoveMode, string>> = { pull: orange, hold: red, 'let-go': grey };

/** What is held in red, what is moved in orange with arrows from where it was, and what a press would take. */
export class HandleLayers {
  readonly #layers: Layers;
  readonly #pointed: CandidateLayers;
  /** What the layers were made of: the handles change with every frame of a drag, the groups do not. */
  #shown: readonly unknown[] = [];

  constructor(layers: Layers) {
    this.#layers = layers;
    this.#pointed = new CandidateLayers(layers);
  }

  /** @param surface null while the mesh has not been looked at: then all are dots */
  show(
    groups: readonly HandleGroup[],
    active: HandleGroup | null,
    handles: Handles,
    { project, surface }: { project: Project | null; surface: SelectableMesh | null },
  ): void {
    const isOrange = (group: HandleGroup) => group.isMoved || group.name === active?.name;
    const held = groups.filter((group) => !isOrange(group)).flatMap(({ vertices }) => vertices);
    const moved = groups.filter(isOrange).flatMap(({ vertices }) => vertices);
    const mesh = project?.mesh;
    const now = [mesh, surface, held.length, held[0], moved.length, moved[0], moved.at(-1)];
    if (now.some((value, k) => value !== this.#shown[k])) {
      this.#tint('handles-held', held, red, mesh, surface);
      this.#tint('handles-moved', moved, orange, mesh, surface);
      this.#shown = now;
    }
    this.#layers.set('handles-arrows', project && arrows(groups, handles, project));
  }

  /** Whole faces are tinted; what has none is dotted. */
  #tint(
    name: string,
    positions: readonly number[],
    color: string,
    mesh: Mesh | undefined,
    surface: SelectableMesh | null,
  ): void {
    if (!mesh || !surface || positions.length === 0) {
      this.#layers.set(`${name}-faces`, null);
      this.#layers.set(name, dots(positions, color));
      return;
    }
    const { vertexOfPosition } = weldOf(mesh);
    const vertices = positions.map((position) => vertexOfPosition[position]!);
    const all = combined(nothing(surface.topology.vertices), vertices, 'add');
    const { faces, vertices: bare } = drawnOf(all, surface.topology);
    this.#layers.set(`${name}-faces`, facesLayer(mesh, faces, color, 0.5));
    this.#layers.set(name, dotsLayer(mesh, bare, color, 6));
  }

  /** @param under what a press would take: a side, edge or rim, or else dots; null for nothing */
  hover(
    project: Project | null,
    mode: MoveMode,
    under: { readonly positions: readonly number[]; readonly candidate?: Candidate | null } | null,
  ): void {
    const color = hoverColors[mode];
    const { positions = [], candidate = null } = under ?? {};
    if (project) this.#pointed.show(project.mesh, candidate, color);
    else this.#pointed.clear();
    this.#layers.set('handles-hover', candidate ? null : dots(positions, color, 4));
  }

  clear(): void {
    this.#shown = [];
    this.#pointed.clear();
    for (const name of this.#layers.names) if (name.startsWith('handles-')) this.#layers.set(name, null);
  }
}

function dots(positions: readonly number[], color: string, size = 6): Layer | null {
  return positions.length > 0 ? { kind: 'points', positions, color, size, depth: 'hidden-behind' } : null;
}

function arrows(groups: readonly HandleGroup[], handles: Handles, project: Project): Layer | null {
  const rest = restShapeOf(project, project.active);
  const moved = groups.filter(({ isMoved }) => isMoved);
  if (!rest || moved.length === 0) return null;
  const from = moved.flatMap(({ vertices }) => centerIn(rest, vertices));
  const to = moved.flatMap(({ vertices }) => targetCenter(handles, vertices));
  return { kind: 'arrows', from, to, width: 2, color: orange, depth: 'in-front' };
}
