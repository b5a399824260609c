import { outlook, targetCenter } from '../../src/editor/handle-groups.ts';
import { shownPositions } from '../../src/editor/project.ts';
import { type Affine, translation } from '../../src/mesh/affine.ts';
import { diagonalOf } from '../../src/mesh/extent.ts';
import { subtract, type Vec3 } from '../../src/mesh/vectors.ts';
import { solvedSourceTriangles, weldOf } from '../../src/mesh/weld.ts';
import { discAround } from '../../src/selection/index.ts';
import type { CanvasPointer } from '../../src/viewer/canvas-tool.ts';
import { Gizmo, type GizmoMode } from '../../src/viewer/gizmo.ts';
import type { Interaction } from '../../src/viewer/interaction.ts';
import type { Hit } from '../../src/viewer/picking/picking.ts';
import type { Grip, HandleActions } from '../app/handle-actions.ts';
import type { PageStore } from '../app/page-state.ts';
import type { Selectable } from '../app/selectable.ts';
import { HandleLayers, type MoveMode } from './handle-layers.ts';
import type { Tool } from './tool.ts';
import { TypedTransform } from './typed-transform.ts';
import { ViewPlane } from './view-plane.ts';

/** How the tool is set. */
export interface MoveOptions {
  readonly mode: MoveMode;
  /** Radius of what is taken, as a share of the mesh's diagonal. */
  readonly size: number;
  /** What is done on one side is done on the other. */
  readonly mirror: boolean;
  readonly gizmo: GizmoMode;
  /** The gizmo's axes are the group's own, the blue one along where it looks, and not the file's. */
  readonly ownAxes: boolean;
}

type Gesture =
  | { readonly kind: 'gizmo'; readonly grip: Grip; by: Affine }
  | { readonly kind: 'pull'; readonly grip: Grip; readonly plane: ViewPlane; by: Affine }
  | { readonly kind: 'stroke'; readonly taken: Set<number> }
  /** It ends what keys began. */
  | { readonly kind: 'click' };

export interface MoveParts {
  readonly store: PageStore;
  readonly interaction: Interaction;
  readonly handles: HandleActions;
  readonly surface: Selectable;
  /** Runs something before the next picture. */
  readonly soon: (run: () => void) => void;
}

/** Holds parts of the mesh still and pulls others, by hand, by gizmo or by keys. */
export class MoveHandles implements Tool {
  options: MoveOptions = { mode: 'pull', size: 0.07, mirror: false, gizmo: 'translate', ownAxes: false };
  /** Under way by keys: G, R or S. */
  typed: { readonly transform: TypedTransform; readonly grip: Grip; readonly plane: ViewPlane } | null = null;
  readonly cursor = 'crosshair';
  readonly #parts: MoveParts;
  readonly #gizmo: Gizmo;
  readonly #layers: HandleLayers;
  #gesture: Gesture | null = null;
  #pointer: CanvasPointer | null = null;
  #isScheduled = false;
  #unlisten: (() => void) | null = null;

  constructor(parts: MoveParts) {
    this.#parts = parts;
    this.#gizmo = new Gizmo(parts.interaction.viewer);
    this.#layers = new HandleLayers(parts.interaction.layers);
  }

  enter(): void {
    this.#unlisten = this.#parts.store.subscribe(() => this.#show());
    this.#show();
  }

  leave(): void {
    this.#dropTyped();
    this.#unlisten?.();
    this.#unlisten = null;
    this.#layers.clear();
    this.#gizmo.hide();
  }

  set(change: Partial<MoveOptions>): void {
    this.options = { ...this.options, ...change };
    this.#gizmo.mode = this.options.gizmo;
    this.#parts.handles.isMirrored = this.options.mirror;
    this.#parts.store.set({});
  }

  hover(pointer: CanvasPointer | null): void {
    this.#pointer = pointer;
    if (this.typed) {
      this.#followTyped();
      return;
    }
    const isGizmos = pointer !== null && this.#gizmo.hover(pointer);
    const hit = pointer && !isGizmos ? this.#parts.interaction.picking.pick(pointer) : null;
    const { mode } = this.options;
    const group = hit && mode === 'pull' ? this.#groupUnder(hit) : undefined;
    this.#layers.hover(hit ? (group?.vertices ?? this.#discUnder(hit)) : [], mode);
    this.#parts.interaction.viewer.invalidate();
  }

  press(pointer: CanvasPointer): boolean {
    this.#pointer = pointer;
    if (this.typed) {
      this.#keepTyped();
      this.#gesture = { kind: 'click' };
      return true;
    }
    const { handles, interaction } = this.#parts;
    if (handles.parameter === undefined) return false;
    const { active } = handles;
    if (active && this.#gizmo.press(pointer)) {
      this.#gesture = { kind: 'gizmo', grip: handles.grip(active), by: translation([0, 0, 0]) };
      return true;
    }
    const hit = interaction.picking.pick(pointer);
    if (!hit) return false;
    this.#gesture = this.options.mode === 'pull' ? this.#beginPull(hit, pointer) : this.#beginStroke(hit);
    return this.#gesture !== null;
  }

  move(pointer: CanvasPointer): void {
    this.#pointer = pointer;
    const gesture = this.#gesture;
    if (gesture?.kind === 'stroke') {
      const hit = this.#parts.interaction.picking.pick(pointer);
      if (hit) this.#addToStroke(gesture.taken, hit);
    } else if (gesture) this.#soon(() => this.#follow());
  }

  release(pointer: CanvasPointer): void {
    this.#pointer = pointer;
    this.#measure();
    const gesture = this.#gesture;
    this.#gesture = null;
    const { handles } = this.#parts;
    if (gesture?.kind === 'gizmo') this.#gizmo.release();
    if (gesture?.kind === 'gizmo') handles.keep(gesture.grip, gesture.by, gizmoLabels[this.options.gizmo]);
    if (gesture?.kind === 'pull') handles.keep(gesture.grip, gesture.by, 'Pull');
    if (gesture?.kind === 'stroke' && this.options.mode === 'hold') handles.hold([...gesture.taken]);
    if (gesture?.kind === 'stroke' && this.options.mode === 'let-go') handles.letGo([...gesture.taken]);
    this.#layers.hover([], this.options.mode);
    this.#show();
  }

  cancel(): void {
    const gesture = this.#gesture;
    this.#gesture = null;
    if (gesture?.kind === 'gizmo') this.#gizmo.release();
    if (gesture?.kind === 'gizmo' || gesture?.kind === 'pull') this.#parts.handles.cancel();
    this.#layers.hover([], this.options.mode);
    this.#show();
  }

  key(event: KeyboardEvent): boolean {
    if (this.typed) return this.#typedKey(event);
    const { active } = this.#parts.handles;
    if (!active || event.ctrlKey || event.metaKey || event.altKey) return false;
    const kind = TypedTransform.kindOf(event.key);
    if (kind) this.#beginTyped(kind);
    else if (event.key === 'Delete' || event.key === 'Backspace') this.#parts.handles.letGo(active.vertices);
    else if (event.key === 'Escape') this.#parts.handles.activate(null);
    else return false;
    return true;
  }

  /** Moves the active group by numbers, in the file's units. */
  shift(by: Vec3): void {
    const { handles } = this.#parts;
    const { active } = handles;
    if (active) handles.keep(handles.grip(active), translation(by), 'Move');
  }

  #beginPull(hit: Hit, pointer: CanvasPointer): Gesture {
    const { handles, interaction } = this.#parts;
    const group = this.#groupUnder(hit);
    const grip = group ? handles.grip(group) : handles.take(this.#discUnder(hit));
    const plane = new ViewPlane(interaction.picking, pointer, hit.point);
    return { kind: 'pull', grip, plane, by: translation([0, 0, 0]) };
  }

  #beginStroke(hit: Hit): Gesture {
    const taken = new Set<number>();
    this.#addToStroke(taken, hit);
    return { kind: 'stroke', taken };
  }

  #addToStroke(taken: Set<number>, hit: Hit): void {
    for (const position of this.#discUnder(hit)) taken.add(position);
    this.#layers.hover([...taken], this.options.mode);
    this.#parts.interaction.viewer.invalidate();
  }

  /** At most one preview a picture: pointers are faster than screens. */
  #soon(run: () => void): void {
    if (this.#isScheduled) return;
    this.#isScheduled = true;
    this.#parts.soon(() => {
      this.#isScheduled = false;
      run();
    });
  }

  #follow(): void {
    this.#measure();
    const gesture = this.#gesture;
    if (gesture?.kind === 'gizmo' || gesture?.kind === 'pull')
      this.#parts.handles.move(gesture.grip, gesture.by);
  }

  /** Brings the movement of the gesture to where the pointer is. */
  #measure(): void {
    const gesture = this.#gesture;
    if (!this.#pointer || !gesture) return;
    if (gesture.kind === 'gizmo') gesture.by = this.#gizmo.move(this.#pointer) ?? gesture.by;
    if (gesture.kind === 'pull') {
      const { from, to } = gesture.plane.way(this.#pointer);
      gesture.by = translation(subtract(to, from));
    }
  }

  #beginTyped(kind: TypedTransform['kind']): void {
    const { handles, interaction } = this.#parts;
    const { active } = handles;
    if (!active) return;
    const pivot = targetCenter(handles.handles, active.vertices);
    const pointer = this.#pointer ?? interaction.picking.project(pivot);
    this.typed = {
      transform: new TypedTransform(kind, pivot),
      grip: handles.grip(active),
      plane: new ViewPlane(interaction.picking, pointer, pivot),
    };
    this.#parts.store.set({});
  }

  #typedKey(event: KeyboardEvent): boolean {
    if (event.key === 'Escape') this.#dropTyped();
    else if (event.key === 'Enter') this.#keepTyped();
    else if (this.typed!.transform.key(event.key)) this.#followTyped();
    else return false;
    return true;
  }

  #followTyped(): void {
    this.#soon(() => {
      if (this.typed) this.#parts.handles.move(this.typed.grip, this.#typedMovement());
    });
  }

  #typedMovement(): Affine {
    const { transform, plane } = this.typed!;
    return transform.movement(this.#pointer ? plane.way(this.#pointer) : null);
  }

  #keepTyped(): void {
    const { grip, transform } = this.typed!;
    const by = this.#typedMovement();
    this.typed = null;
    this.#parts.handles.keep(grip, by, transform.sentence.split(' ')[0]!);
  }

  #dropTyped(): void {
    if (!this.typed) return;
    this.typed = null;
    this.#parts.handles.cancel();
    this.#show();
  }

  #groupUnder({ corners, weights }: Hit) {
    return this.#parts.handles.groupAt(corners[weights.indexOf(Math.max(...weights))]!);
  }

  /** Positions of the file under the brush; one alone until the mesh has been looked at. */
  #discUnder(hit: Hit): number[] {
    const { project } = this.#parts.store.state;
    const surface = project && this.#parts.surface.of(project);
    if (!project || !surface) return [hit.corners[hit.weights.indexOf(Math.max(...hit.weights))]!];
    const vertices = discAround(surface, hit, this.options.size * diagonalOf(project.mesh));
    const { positionOfVertex } = weldOf(project.mesh);
    return Array.from(vertices, (vertex) => positionOfVertex[vertex]!);
  }

  #axesOf(vertices: readonly number[]): readonly [number, number, number, number] | undefined {
    const { project } = this.#parts.store.state;
    if (!this.options.ownAxes || !project) return undefined;
    const normal = outlook(shownPositions(project), solvedSourceTriangles(project.mesh), vertices);
    return turnFromZ(normal);
  }

  #show(): void {
    const { handles, store } = this.#parts;
    const { active, groups } = handles;
    const { project } = store.state;
    if (project) this.#parts.surface.of(project);
    handles.seekMirror();
    this.#layers.show(groups, active, handles.handles, project);
    if (!active || this.typed || this.#gesture?.kind === 'pull') this.#gizmo.hide();
    else this.#gizmo.show(targetCenter(handles.handles, active.vertices), this.#axesOf(active.vertices));
  }
}

/** The shortest turn of the z axis to a direction, as a quaternion; undefined for no direction. */
function turnFromZ([x, y, z]: Vec3): readonly [number, number, number, number] | undefined {
  if (x === 0 && y === 0 && z === 0) return undefined;
  if (z < -1 + 1e-9) return [1, 0, 0, 0];
  const length = Math.hypot(-y, x, 1 + z);
  return [-y / length, x / length, 0, (1 + z) / length];
}

const gizmoLabels: Readonly<Record<GizmoMode, string>> = {
  translate: 'Move',
  rotate: 'Turn',
  scale: 'Scale',
};
