import { Quaternion as Turn } from 'three';
import type { Editor } from '../../src/editor/editor.ts';
import { activeStep, type Project } from '../../src/editor/project.ts';
import { turnedRegion, withoutRegion, withRegion } from '../../src/editor/regions.ts';
import type { Vec3 } from '../../src/mesh/vectors.ts';
import { findMethod } from '../../src/methods/registry.ts';
import {
  axesParameter,
  orientationParameter,
  polyhedronParameter,
  regionsParameter,
} from '../../src/methods/set-by-hand.ts';
import type { ChoiceParameter } from '../../src/methods/values/choice.ts';
import type { ParameterValue, ParameterValues } from '../../src/methods/values/index.ts';
import type { Directions } from '../../src/methods/values/points.ts';
import type { Quaternion } from '../../src/methods/values/rotation.ts';
import type { Regions } from '../../src/methods/values/rotations.ts';
import type { PageStore } from './page-state.ts';

const unturned: Quaternion = [0, 0, 0, 1];

/** What the mesh is drawn to: which polyhedron, how it is turned, how it is stretched, and where there is another one. */
export class CubeActions {
  readonly #store: PageStore;
  readonly #editor: Editor;
  /** The region whose cube is turned; null for the one of all the rest. */
  #region: number | null = null;

  constructor(store: PageStore, editor: Editor) {
    this.#store = store;
    this.#editor = editor;
  }

  get project(): Project | null {
    return this.#store.state.project;
  }

  /** Whether the active step draws to something that can be turned. */
  get isTurnable(): boolean {
    return this.#named(orientationParameter) !== undefined;
  }

  get polyhedron(): ChoiceParameter | undefined {
    const { project } = this;
    return project ? polyhedronParameter(findMethod(activeStep(project).method)) : undefined;
  }

  /** The name of the polyhedron, or rows of one's own. */
  get chosen(): string | Directions {
    const { polyhedron } = this;
    return (polyhedron && (this.#value(polyhedron.name) as string | Directions)) ?? polyhedron?.default ?? '';
  }

  /** The edges of what the mesh is drawn to, stretched as the axes say, not turned. */
  get rows(): readonly Vec3[] {
    const { chosen, polyhedron, axes } = this;
    if (typeof chosen !== 'string') return chosen as readonly Vec3[];
    const rows = (polyhedron?.rows?.[chosen] ?? []) as readonly Vec3[];
    return this.isBox ? rows.map((row) => [row[0] * axes[0], row[1] * axes[1], row[2] * axes[2]]) : rows;
  }

  /** Only the cube has axes to stretch. */
  get isBox(): boolean {
    return this.#named(axesParameter) !== undefined && this.chosen === this.polyhedron?.default;
  }

  get axes(): Vec3 {
    const name = this.#named(axesParameter);
    return ((name && this.#value(name)) as Vec3 | undefined) ?? [1, 1, 1];
  }

  get regions(): Regions {
    const name = this.#named(regionsParameter);
    return ((name && this.#value(name)) as Regions | undefined) ?? [];
  }

  get takesRegions(): boolean {
    return this.#named(regionsParameter) !== undefined;
  }

  /** The place in the list of the region that is turned; null for all the rest. */
  get region(): number | null {
    return this.#region !== null && this.#region < this.regions.length ? this.#region : null;
  }

  chooseRegion(region: number | null): void {
    this.#region = region;
    this.#store.set({});
  }

  /** Of the cube that is turned. */
  get orientation(): Quaternion {
    const { region } = this;
    if (region !== null) return this.regions[region]!.orientation;
    const name = this.#named(orientationParameter);
    return ((name && this.#value(name)) as Quaternion | undefined) ?? unturned;
  }

  /** Follows a hand that turns. @param turn against how it was turned when the hand took it, `from` */
  turn(from: Quaternion, turn: Quaternion, isDone: boolean): void {
    const after = new Turn(...turn).multiply(new Turn(...from)).normalize();
    this.#set(this.#turned(after.toArray() as unknown as Quaternion), isDone ? 'Turn the cube' : null);
  }

  straighten(): void {
    this.#set(this.#turned(unturned), 'Straighten the cube');
  }

  stretch(axes: Vec3, isDone: boolean): void {
    const name = this.#named(axesParameter);
    if (name) this.#set({ [name]: axes }, isDone ? 'Stretch the cube' : null);
  }

  /** A polyhedron by its name, or by rows of one's own. */
  choose(polyhedron: string | Directions): void {
    const { polyhedron: parameter } = this;
    const axes = this.#named(axesParameter);
    if (!parameter) return;
    // Others have no axes to stretch.
    const unstretched = polyhedron === parameter.default || !axes ? {} : { [axes]: undefined };
    this.#set({ [parameter.name]: polyhedron, ...unstretched }, 'Polyhedron');
  }

  /** Gives a part of the mesh a cube of its own, turned as the one it had; it is the one that is turned next. */
  addRegion(positions: readonly number[]): void {
    const { project } = this;
    const name = this.#named(regionsParameter);
    if (!project || !name || positions.length === 0) return;
    const regions = withRegion(this.regions, project.mesh, positions, this.orientation);
    this.#region = regions.length - 1;
    this.#set({ [name]: regions }, 'Cube of its own');
  }

  removeRegion(region: number): void {
    const name = this.#named(regionsParameter);
    this.#region = null;
    if (name) this.#set({ [name]: withoutRegion(this.regions, region) }, 'Remove a cube');
  }

  /** Takes the gesture that is under way back. */
  cancel(): void {
    this.#editor.dropGesture();
  }

  #turned(orientation: Quaternion): Changes {
    const { region } = this;
    const regions = this.#named(regionsParameter);
    if (region !== null && regions) return { [regions]: turnedRegion(this.regions, region, orientation) };
    return { [this.#named(orientationParameter)!]: orientation };
  }

  /** @param label what undo calls it; null while a gesture is under way */
  #set(changes: Changes, label: string | null): void {
    const { parameters: present } = activeStep(this.project!);
    const entries = Object.entries({ ...present, ...changes }).filter(([, value]) => value !== undefined);
    const parameters = Object.fromEntries(entries) as ParameterValues;
    if (label === null) this.#editor.preview({ parameters });
    else this.#editor.commit({ parameters }, label);
  }

  #value(name: string): ParameterValue | undefined {
    return activeStep(this.project!).parameters[name];
  }

  #named(parameter: (method: ReturnType<typeof findMethod>) => string | undefined): string | undefined {
    const { project } = this;
    return project ? parameter(findMethod(activeStep(project).method)) : undefined;
  }
}

type Changes = Readonly<Record<string, ParameterValue | undefined>>;
