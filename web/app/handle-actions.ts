import type { Editor } from '../../src/editor/editor.ts';
import { freeGroupName } from '../../src/editor/groups.ts';
import {
  footing,
  type HandleGroup,
  handleGroups,
  movedHandles,
  noHandles,
  spelledOut,
  withHandles,
  withoutHandles,
} from '../../src/editor/handle-groups.ts';
import { activeStep, type Project, restShapeOf } from '../../src/editor/project.ts';
import { formatInfo } from '../../src/io/index.ts';
import { type Affine, mirrored } from '../../src/mesh/affine.ts';
import { weldOf } from '../../src/mesh/weld.ts';
import { findMethod } from '../../src/methods/registry.ts';
import { handlesParameter } from '../../src/methods/set-by-hand.ts';
import type { Handles } from '../../src/methods/values/handles.ts';
import type { Group } from '../../src/recipe/index.ts';
import { alone, type MirrorMap } from '../../src/selection/index.ts';
import { Mirror } from './mirrors.ts';
import type { PageStore } from './page-state.ts';

/** What is held and what is moved of the mesh: all that buttons, keys and the tool on the canvas can ask for. */
export class HandleActions {
  readonly #store: PageStore;
  readonly #editor: Editor;
  #active: string | null = null;
  /** What is done on one side is done on the other. */
  isMirrored = false;
  readonly #mirror = new Mirror();

  constructor(store: PageStore, editor: Editor) {
    this.#store = store;
    this.#editor = editor;
  }

  get project(): Project | null {
    return this.#store.state.project;
  }

  /** The name by which the active step takes handles; undefined where it takes none. */
  get parameter(): string | undefined {
    const { project } = this;
    return project ? handlesParameter(findMethod(activeStep(project).method)) : undefined;
  }

  get handles(): Handles {
    const { project, parameter } = this;
    const value = project && parameter && activeStep(project).parameters[parameter];
    const rest = value && restShapeOf(project, project.active);
    return rest ? spelledOut(value as Handles, rest) : noHandles;
  }

  get groups(): readonly HandleGroup[] {
    const { project } = this;
    const rest = project && restShapeOf(project, project.active);
    return rest ? handleGroups(this.handles, project.groups, rest) : [];
  }

  /** The group that gizmo, keys and numbers move; null if it is gone. */
  get active(): HandleGroup | null {
    return this.groups.find(({ name }) => name === this.#active) ?? null;
  }

  /** The mirror that groups have a partner behind; null where none is wanted or it is not known yet. */
  get mirror(): MirrorMap | null {
    const { project } = this;
    return this.isMirrored && project ? this.#mirror.of(project.mesh, () => this.#store.set({})) : null;
  }

  /** Has the mirror found before the first gesture that needs it. */
  seekMirror(): boolean {
    return this.mirror !== null;
  }

  activate(name: string | null): void {
    this.#active = name;
    this.#store.set({});
  }

  /** The group that a position is in. */
  groupAt(position: number): HandleGroup | undefined {
    const vertex = this.#vertexOf(position);
    return this.groups.find(({ vertices }) => vertices.some((other) => this.#vertexOf(other) === vertex));
  }

  /** Holds positions where they are at rest. */
  hold(positions: readonly number[]): void {
    const { project } = this;
    const rest = project && restShapeOf(project, project.active);
    if (!rest || positions.length === 0) return;
    const all = this.#withPartners(positions);
    const held = this.groups.find(({ isMoved, name }) => !isMoved && name.startsWith(heldName));
    const name = held?.name ?? freeGroupName(project.groups, heldName);
    const members = [...new Set([...(held?.vertices ?? []), ...all])];
    this.#commit(
      withHandles(this.handles, all, rest),
      this.#regrouped([{ name, vertices: members }]),
      'Hold',
    );
  }

  /** Lets positions go, whatever groups they are in. */
  letGo(positions: readonly number[]): void {
    const gone = new Set(this.#withPartners(positions).map((position) => this.#vertexOf(position)));
    const { vertices } = this.handles;
    const members = vertices.filter((vertex) => gone.has(this.#vertexOf(vertex)));
    if (members.length === 0) return;
    this.#commit(withoutHandles(this.handles, members), this.#regrouped([], members), 'Let go');
  }

  letAllGo(): void {
    const { vertices } = this.handles;
    if (vertices.length > 0) this.#commit(noHandles, this.#regrouped([], vertices), 'Let all go');
  }

  /**
   * Begins a gesture with positions that become a group of their own, where they are now.
   *
   * @param base what is to stay if nothing is held yet; default what the mesh stands on
   * @returns what the gesture moves
   */
  take(
    positions: readonly number[],
    { label = movedName, base: wanted }: { label?: string; base?: readonly number[] | undefined } = {},
  ): Grip {
    const project = this.project!;
    const places = activeStep(project).result?.positions ?? restShapeOf(project, project.active)!;
    const partners = this.#partnersOf(positions);
    const name = nameOfSame(project.groups, positions) ?? freeGroupName(project.groups, label);
    const made: Group[] = [{ name, vertices: positions }];
    if (partners.length > 0)
      made.push({ name: freeGroupName([...project.groups, ...made], label), vertices: partners });
    const all = made.flatMap(({ vertices }) => vertices);
    this.#active = name;
    const base = this.#base(all, wanted);
    const from = withHandles(this.handles, all, places);
    const grip = {
      group: positions,
      partners,
      from: base ? withHandles(from, base.vertices, base.rest) : from,
    };
    if (base) made.push({ name: baseName, vertices: base.vertices });
    this.#preview(grip.from, this.#regrouped(made, all));
    return grip;
  }

  /** What is held where nothing is yet: with nothing to pull against, all of it would come along. */
  #base(
    taken: readonly number[],
    wanted: readonly number[] | undefined,
  ): { vertices: readonly number[]; rest: Float64Array } | null {
    const project = this.project!;
    const rest = restShapeOf(project, project.active);
    if (!rest || this.handles.vertices.length > 0) return null;
    if (wanted && wanted.length > 0) return { vertices: wanted, rest };
    const { positionOfVertex } = weldOf(project.mesh);
    const up = formatInfo(project.source.format).up === 'z' ? 2 : 1;
    return { vertices: footing(rest, positionOfVertex, taken, up), rest };
  }

  /** Begins a gesture with a group that is there. */
  grip({ name, vertices }: HandleGroup): Grip {
    this.#active = name;
    const partners = this.#partnersOf(vertices);
    const have = new Set(this.handles.vertices);
    // Partners move with it if they are handles themselves.
    const both = partners.filter((vertex) => have.has(vertex));
    return { group: vertices, partners: both, from: this.handles };
  }

  /** Shows what a movement makes of a grip; the newest is what counts. */
  move(grip: Grip, by: Affine): void {
    this.#preview(movedBy(grip, by, this.mirror));
  }

  /** Ends the gesture. */
  keep(grip: Grip, by: Affine, label: string): void {
    this.#commit(movedBy(grip, by, this.mirror), undefined, label);
  }

  /** Takes the gesture back. */
  cancel(): void {
    this.#editor.dropGesture();
  }

  #preview(handles: Handles, groups?: readonly Group[]): void {
    this.#editor.preview({ ...this.#change(handles), ...(groups ? { groups } : {}) });
  }

  #commit(handles: Handles, groups: readonly Group[] | undefined, label: string): void {
    this.#editor.commit({ ...this.#change(handles), ...(groups ? { groups } : {}) }, label);
  }

  #change(handles: Handles) {
    const { parameter } = this;
    const { [parameter!]: _, ...others } = activeStep(this.project!).parameters;
    return { parameters: handles.vertices.length > 0 ? { ...others, [parameter!]: handles } : others };
  }

  /** The project's groups with some made or changed, and without members that went to others; none stays without members. */
  #regrouped(made: readonly Group[], moved: readonly number[] = []): readonly Group[] {
    const names = new Set(made.map(({ name }) => name));
    const gone = new Set([...moved, ...made.flatMap(({ vertices }) => vertices)]);
    const handled = new Set(this.groups.map(({ name }) => name));
    const others = this.project!.groups.filter(({ name }) => !names.has(name))
      // A group that is no handle group is a selection with a name, and keeps what it has.
      .map((group) =>
        handled.has(group.name)
          ? { name: group.name, vertices: group.vertices.filter((vertex) => !gone.has(vertex)) }
          : group,
      )
      .filter(({ vertices }) => vertices.length > 0);
    return [...others, ...made];
  }

  #withPartners(positions: readonly number[]): readonly number[] {
    return [...new Set([...positions, ...this.#partnersOf(positions)])];
  }

  /** The positions behind the mirror, but those that are their own partners or members themselves. */
  #partnersOf(positions: readonly number[]): readonly number[] {
    const { mirror, project } = this;
    if (!mirror || !project) return [];
    const { positionOfVertex } = weldOf(project.mesh);
    const own = new Set(positions.map((position) => this.#vertexOf(position)));
    const partners = [...own].map((vertex) => mirror.partner[vertex]!);
    return partners
      .filter((vertex) => vertex !== alone && !own.has(vertex))
      .map((vertex) => positionOfVertex[vertex]!);
  }

  #vertexOf(position: number): number {
    return weldOf(this.project!.mesh).vertexOfPosition[position]!;
  }
}

/** The name of the group that has the very same positions: it becomes what is moved, and no second one beside it. */
function nameOfSame(groups: readonly Group[], positions: readonly number[]): string | undefined {
  const wanted = new Set(positions);
  return groups.find(
    ({ vertices }) => vertices.length === wanted.size && vertices.every((vertex) => wanted.has(vertex)),
  )?.name;
}

/** What groups are called before a person calls them something else. */
const heldName = 'Held';
const baseName = 'Base';
const movedName = 'Moved';

/** What a gesture has hold of, and the handles as they were when it began. */
export interface Grip {
  readonly group: readonly number[];
  /** These move as in a mirror. */
  readonly partners: readonly number[];
  readonly from: Handles;
}

function movedBy({ group, partners, from }: Grip, by: Affine, mirror: MirrorMap | null): Handles {
  const moved = movedHandles(from, group, by);
  if (!mirror || partners.length === 0) return moved;
  return movedHandles(moved, partners, mirrored(by, mirror.plane.axis, mirror.plane.offset));
}
