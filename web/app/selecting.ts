import type { Editor } from '../../src/editor/editor.ts';
import { freeGroupName, renamedGroup, withGroup, withoutGroup } from '../../src/editor/groups.ts';
import { type Project, shownPositions } from '../../src/editor/project.ts';
import type { Mesh } from '../../src/mesh/mesh.ts';
import { weldOf } from '../../src/mesh/weld.ts';
import {
  aloneIn,
  type Combination,
  combined,
  everything,
  grown,
  inSlices,
  inverted,
  type MirrorMap,
  type MirrorPlane,
  mirrored,
  nothing,
  type SelectableMesh,
  type Selection,
  selectableOf,
  selectedVertices,
  shrunk,
} from '../../src/selection/index.ts';
import { mirrorOf } from './mirrors.ts';
import type { PageStore } from './page-state.ts';
import type { SelectState } from './select-state.ts';

/** All that buttons, keys and the tool can ask for about what is selected, and about named groups. */
export class Selecting {
  readonly #store: PageStore;
  readonly #editor: Editor;
  /** What there is to select, of the shape that rested last; null while it is not known yet. */
  #surface: SelectableMesh | null = null;
  #mesh: Mesh | null = null;
  #builtFrom: readonly unknown[] = [];
  #building: AbortController | null = null;
  #isWanted = false;

  constructor(store: PageStore, editor: Editor) {
    this.#store = store;
    this.#editor = editor;
    store.subscribe(({ project }) => this.#follow(project));
  }

  get surface(): SelectableMesh | null {
    return this.#surface;
  }

  get selection(): Selection | null {
    return this.#store.state.select.selection;
  }

  /** Keeps {@link surface} from now on. */
  want(): void {
    this.#isWanted = true;
    this.#follow(this.#store.state.project);
  }

  set(change: Partial<SelectState>): void {
    this.#store.set({ select: { ...this.#store.state.select, ...change } });
    if (change.angle !== undefined) this.#follow(this.#store.state.project);
  }

  /** Puts another set of vertices in place of what is selected. */
  put(selection: Selection, remark: string | null = null): void {
    this.set({ selection, remark });
  }

  /** @param vertices welded */
  combine(vertices: Iterable<number>, how: Combination): void {
    if (this.selection) this.put(combined(this.selection, vertices, how));
  }

  all(): void {
    if (this.selection) this.put(everything(this.selection.marks.length));
  }

  /** @returns whether anything was selected */
  none(): boolean {
    if (!this.selection || this.selection.count === 0) return false;
    this.put(nothing(this.selection.marks.length));
    return true;
  }

  invert(): void {
    if (this.selection) this.put(inverted(this.selection));
  }

  grow(): void {
    if (this.selection && this.#surface) this.put(grown(this.selection, this.#surface.topology));
  }

  shrink(): void {
    if (this.selection && this.#surface) this.put(shrunk(this.selection, this.#surface.topology));
  }

  /** Selects the mirror image too; says how much of it there is not. @param axis default that of the best symmetry */
  async mirror(axis?: MirrorPlane['axis']): Promise<void> {
    const mesh = this.#mesh;
    const { selection } = this;
    if (!mesh || !selection || selection.count === 0) return;
    const axes = axis === undefined ? ([0, 1, 2] as const) : [axis];
    const maps = await Promise.all(axes.map((one) => mirrorOf(mesh, one)));
    const map = maps.reduce((best, other) => (other.alone < best.alone ? other : best));
    if (mesh !== this.#mesh || selection !== this.selection) return;
    const both = combined(selection, selectedVertices(mirrored(selection, map)), 'add');
    this.put(both, mirrorRemark(selection, map));
  }

  /** The selected vertices as the file numbers them: the first position of each. */
  get positions(): number[] {
    if (!this.#mesh || !this.selection) return [];
    const { positionOfVertex } = weldOf(this.#mesh);
    return Array.from(selectedVertices(this.selection), (vertex) => positionOfVertex[vertex]!);
  }

  /** Gives what is selected a name. @returns the name, which has a number after it if there was such a group already */
  name(wanted: string): string | null {
    const vertices = this.positions;
    const { project } = this.#store.state;
    if (!project || vertices.length === 0) return null;
    const name = freeGroupName(project.groups, wanted.trim() || 'Group');
    this.#editor.changeGroups((groups) => withGroup(groups, { name, vertices }), `Name “${name}”`);
    return name;
  }

  /** Selects a group, or puts it to or takes it from what is selected. */
  take(name: string, how: Combination): void {
    const group = this.#store.state.project?.groups.find((one) => one.name === name);
    if (!group || !this.#mesh) return;
    const { vertexOfPosition } = weldOf(this.#mesh);
    this.combine(
      group.vertices.map((position) => vertexOfPosition[position]!),
      how,
    );
  }

  /** Puts what is selected to a group, or takes it out of it. */
  changeGroup(name: string, how: 'add' | 'remove'): void {
    const selected = new Set(this.positions);
    if (selected.size === 0) return;
    const label = how === 'add' ? `Add to “${name}”` : `Take out of “${name}”`;
    this.#editor.changeGroups((groups) => {
      const group = groups.find((one) => one.name === name);
      if (!group) return groups;
      const kept = group.vertices.filter((vertex) => !selected.has(vertex));
      const vertices = how === 'add' ? [...kept, ...selected].sort((a, b) => a - b) : kept;
      return vertices.length === 0 ? withoutGroup(groups, name) : withGroup(groups, { name, vertices });
    }, label);
  }

  rename(from: string, to: string): void {
    this.#editor.changeGroups((groups) => renamedGroup(groups, from, to), `Rename “${from}”`);
  }

  forget(name: string): void {
    this.#editor.changeGroups((groups) => withoutGroup(groups, name), `Forget “${name}”`);
  }

  #follow(project: Project | null): void {
    const mesh = project?.mesh ?? null;
    if (mesh !== this.#mesh) {
      this.#mesh = mesh;
      this.#surface = null;
      this.#builtFrom = [];
      const selection = mesh ? nothing(weldOf(mesh).positionOfVertex.length) : null;
      this.set({ selection, pointed: null, remark: null });
    }
    if (!this.#isWanted || !project) return;
    // A shape that moves is not followed; lines and patches are those of the one that rested last.
    if (this.#surface && this.#store.state.activity.kind === 'solving') return;
    this.#build(project);
  }

  #build(project: Project): void {
    const positions = shownPositions(project);
    const { angle } = this.#store.state.select;
    const from = [project.mesh, positions, angle];
    if (from.every((value, k) => value === this.#builtFrom[k])) return;
    this.#builtFrom = from;
    this.#building?.abort();
    this.#building = new AbortController();
    const { signal } = this.#building;
    inSlices(selectableOf(project.mesh, { positions, angle }), { signal }).then(
      (surface) => {
        if (signal.aborted) return;
        this.#surface = surface;
        this.set({ pointed: null });
      },
      () => {},
    );
  }
}

const count = new Intl.NumberFormat('en');

function mirrorRemark(selection: Selection, map: MirrorMap): string {
  const lost = aloneIn(selection, map);
  if (lost === 0) return 'The mirror image is selected too.';
  if (lost === selection.count) return 'Nothing lies opposite: the mesh is not symmetric that way.';
  return `The mirror image is selected too; ${count.format(lost)} of ${count.format(selection.count)} have nothing opposite.`;
}

/** How much is selected, in words. */
export function selectionSentence({ marks, count: selected }: Selection): string {
  if (selected === 0) return 'Nothing is selected.';
  if (selected === marks.length) return `All ${count.format(selected)} vertices are selected.`;
  return `${count.format(selected)} of ${count.format(marks.length)} vertices ${selected === 1 ? 'is' : 'are'} selected.`;
}
