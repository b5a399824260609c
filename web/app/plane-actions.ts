import type { Editor } from '../../src/editor/editor.ts';
import { placedPlane, withoutPlane, withPlane } from '../../src/editor/planes.ts';
import { activeStep, type Project, shownPositions } from '../../src/editor/project.ts';
import { add, dot, length, scale, type Vec3 } from '../../src/mesh/vectors.ts';
import { findMethod } from '../../src/methods/registry.ts';
import { planesParameter } from '../../src/methods/set-by-hand.ts';
import type { Plane, Planes } from '../../src/methods/values/planes.ts';
import { fittedPlane, reachOf } from '../../src/selection/index.ts';
import type { PageStore } from './page-state.ts';

/** A plane as it is drawn. */
export interface PlaneSheet {
  /** The middle of what is held on it. */
  readonly center: Vec3;
  /** Of length 1. */
  readonly normal: Vec3;
  /** From the middle to what is farthest, in file units. */
  readonly reach: number;
}

/** The planes that parts of the mesh are held on: all that buttons and the tool on the canvas can ask for. */
export class PlaneActions {
  readonly #store: PageStore;
  readonly #editor: Editor;

  constructor(store: PageStore, editor: Editor) {
    this.#store = store;
    this.#editor = editor;
  }

  get project(): Project | null {
    return this.#store.state.project;
  }

  /** The name by which the active step takes planes; undefined where it takes none. */
  get parameter(): string | undefined {
    const { project } = this;
    return project ? planesParameter(findMethod(activeStep(project).method)) : undefined;
  }

  get planes(): Planes {
    const { project, parameter } = this;
    const value = project && parameter && activeStep(project).parameters[parameter];
    return (value as Planes | undefined) ?? [];
  }

  /** Holds positions on the plane that they lie nearest to as they are seen. */
  hold(positions: readonly number[]): void {
    const { project } = this;
    if (!project || this.parameter === undefined || positions.length === 0) return;
    const { normal, offset } = fittedPlane(shownPositions(project), positions);
    const plane: Plane = { vertices: positions, normal, offset };
    this.#set(withPlane(this.planes, project.mesh, plane), 'Hold on a plane');
  }

  /** Lays a plane across an axis, or as its vertices lie, through the middle of these. */
  lay(index: number, axis: 0 | 1 | 2 | null): void {
    const { project } = this;
    const plane = this.planes[index];
    if (!project || !plane) return;
    const fitted = fittedPlane(shownPositions(project), plane.vertices);
    const normal = axis === null ? fitted.normal : axes[axis];
    const place = { normal, offset: dot(normal, fitted.center) };
    this.#set(placedPlane(this.planes, index, place), 'Turn the plane');
  }

  /** Moves a plane along its normal. @param isDone the gesture has ended */
  shift(index: number, offset: number, isDone: boolean): void {
    if (Number.isFinite(offset))
      this.#set(placedPlane(this.planes, index, { offset }), isDone ? 'Move the plane' : null);
  }

  remove(index: number): void {
    this.#set(withoutPlane(this.planes, index), 'Remove the plane');
  }

  /** Takes the gesture that is under way back. */
  cancel(): void {
    this.#editor.dropGesture();
  }

  sheetOf({ vertices, normal: given, offset }: Plane): PlaneSheet {
    const shape = shownPositions(this.project!);
    const { center: middle } = fittedPlane(shape, vertices);
    const normal = scale(given, 1 / length(given));
    const center = add(middle, scale(normal, offset / length(given) - dot(normal, middle)));
    return { center, normal, reach: reachOf(shape, vertices, middle) };
  }

  /** @param label what undo calls it; null while a gesture is under way */
  #set(planes: Planes, label: string | null): void {
    const { parameter } = this;
    if (parameter === undefined) return;
    const { [parameter]: _, ...others } = activeStep(this.project!).parameters;
    const parameters = planes.length > 0 ? { ...others, [parameter]: planes } : others;
    if (label === null) this.#editor.preview({ parameters });
    else this.#editor.commit({ parameters }, label);
  }
}

const axes = [
  [1, 0, 0],
  [0, 1, 0],
  [0, 0, 1],
] as const;
