import { type HandleGroup, outlook, targetCenter } from '../../src/editor/handle-groups.ts';
import { shownPositions } from '../../src/editor/project.ts';
import { type Affine, translation } from '../../src/mesh/affine.ts';
import { length, subtract, type Vec3 } from '../../src/mesh/vectors.ts';
import { solvedSourceTriangles } from '../../src/mesh/weld.ts';
import type { CanvasPointer } from '../../src/viewer/canvas-tool.ts';
import { Gizmo, type GizmoMode } from '../../src/viewer/gizmo.ts';
import type { Interaction } from '../../src/viewer/interaction.ts';
import type { Grip, HandleActions } from '../app/handle-actions.ts';
import type { PageStore } from '../app/page-state.ts';
import type { Selectable } from '../app/selectable.ts';
import { HandleLayers, type MoveMode } from './handle-layers.ts';
import { isStill } from './select-gestures.ts';
import { type TakeWay, Taking, type Under } from './taking.ts';
import type { Tool } from './tool.ts';
import { TypedMove } from './typed-move.ts';
import { TypedTransform } from './typed-transform.ts';
import { ViewPlane } from './view-plane.ts';

/** How the tool is set. */
export interface MoveOptions {
  readonly mode: MoveMode;
  /** What a press takes; null for what suits the method. */
  readonly take: TakeWay | null;
  /** A side goes in and out alone, and not sideways. */
  readonly straight: boolean;
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
  | {
      readonly kind: 'pull';
      readonly grip: Grip;
      readonly plane: ViewPlane;
      readonly from: CanvasPointer;
      /** It is no click any more. */
      hasMoved: boolean;
      /** Where alone it goes; null for anywhere. */
      readonly along: Vec3 | null;
      by: Affine;
    }
  | { readonly kind: 'stroke'; readonly mode: MoveMode; readonly taken: Set<number> }
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
  options: MoveOptions = {
    mode: 'pull',
    take: null,
    straight: true,
    size: 0.07,
    mirror: false,
    gizmo: 'translate',
    ownAxes: false,
  };
  /** Under way by keys. */
  typed: TypedMove | null = null;
  readonly cursor = 'crosshair';
  readonly #parts: MoveParts;
  readonly #gizmo: Gizmo;
  readonly #layers: HandleLayers;
  readonly #taking: Taking;
  #gesture: Gesture | null = null;
  #pointer: CanvasPointer | null = null;
  #isScheduled = false;
  #unlisten: (() => void) | null = null;
  /** Whether the group of a name is a side that goes in and out; measured once for the handles that there are. */
  #pushed: { of: readonly unknown[]; is: boolean } = { of: [null], is: false };

  constructor(parts: MoveParts) {
    this.#parts = parts;
    this.#gizmo = new Gizmo(parts.interaction.viewer);
    this.#layers = new HandleLayers(parts.interaction.layers);
    this.#taking = new Taking(parts);
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

  /** What a press takes. */
  get take(): TakeWay {
    return this.#taking.way;
  }

  set(change: Partial<MoveOptions>): void {
    this.options = { ...this.options, ...change };
    this.#gizmo.mode = this.options.gizmo;
    this.#taking.size = this.options.size;
    this.#taking.wanted = this.options.take;
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
    const under = pointer && !isGizmos ? this.#taking.at(pointer) : null;
    const mode = pointer ? this.#modeOf(pointer) : 'pull';
    const group = under && mode !== 'hold' ? this.#taking.groupAt(under) : undefined;
    this.#layers.hover(this.#parts.store.state.project, mode, group ? { positions: group.vertices } : under);
    this.#parts.interaction.viewer.invalidate();
  }

  press(pointer: CanvasPointer): boolean {
    this.#pointer = pointer;
    if (this.typed) {
      this.#keepTyped();
      this.#gesture = { kind: 'click' };
      return true;
    }
    const { handles } = this.#parts;
    if (handles.parameter === undefined) return false;
    const { active } = handles;
    if (active && this.#gizmo.press(pointer)) {
      this.#gesture = { kind: 'gizmo', grip: handles.grip(active), by: translation([0, 0, 0]) };
      return true;
    }
    const under = this.#taking.at(pointer);
    if (!under) return false;
    const mode = this.#modeOf(pointer);
    this.#gesture = mode === 'pull' ? this.#beginPull(under, pointer) : this.#beginStroke(under, mode);
    return true;
  }

  move(pointer: CanvasPointer): void {
    this.#pointer = pointer;
    const gesture = this.#gesture;
    if (gesture?.kind === 'stroke') {
      const under = this.#taking.at(pointer);
      if (under) this.#addToStroke(gesture, under);
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
    if (gesture?.kind === 'pull')
      handles.keep(gesture.grip, gesture.by, gesture.hasMoved ? 'Pull' : 'Take hold');
    if (gesture?.kind === 'stroke' && gesture.mode === 'hold') handles.hold([...gesture.taken]);
    if (gesture?.kind === 'stroke' && gesture.mode === 'let-go') handles.letGo([...gesture.taken]);
    this.#layers.hover(null, this.options.mode, null);
    this.#show();
  }

  cancel(): void {
    const gesture = this.#gesture;
    this.#gesture = null;
    if (gesture?.kind === 'gizmo') this.#gizmo.release();
    if (gesture?.kind === 'gizmo' || gesture?.kind === 'pull') this.#parts.handles.cancel();
    this.#layers.hover(null, this.options.mode, null);
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

  /** With Shift down what would be pulled is held still instead. */
  #modeOf({ shift }: CanvasPointer): MoveMode {
    const { mode } = this.options;
    return mode === 'pull' && shift && this.take === 'side' ? 'hold' : mode;
  }

  #beginPull(under: Under, pointer: CanvasPointer): Gesture {
    const { handles, interaction } = this.#parts;
    const group = this.#taking.groupAt(under);
    const along = this.#outwards(group?.vertices ?? under.positions);
    // What is held already is enough to pull against.
    const base = handles.handles.vertices.length > 0 ? undefined : this.#taking.opposite(under);
    const grip = group ? handles.grip(group) : handles.take(under.positions, { base });
    const plane = new ViewPlane(interaction.picking, pointer, under.hit.point);
    return { kind: 'pull', grip, plane, from: pointer, hasMoved: false, along, by: translation([0, 0, 0]) };
  }

  /** Where a side that goes in and out alone looks; null for what goes anywhere. */
  #outwards(positions: readonly number[]): Vec3 | null {
    if (this.take !== 'side' || !this.options.straight) return null;
    const way = this.#outlook(positions);
    return way && length(way) > 0 ? way : null;
  }

  /** Whether the active group goes in and out as it is dragged itself: a gizmo there would only be in the way. */
  #isPushed({ name, vertices }: HandleGroup): boolean {
    const { handles } = this.#parts.handles;
    const now = [handles, name, this.take, this.options.straight];
    if (now.some((value, k) => value !== this.#pushed.of[k]))
      this.#pushed = { of: now, is: this.#outwards(vertices) !== null };
    return this.#pushed.is && this.options.gizmo === 'translate';
  }

  #beginStroke(under: Under, mode: MoveMode): Gesture {
    const gesture = { kind: 'stroke', mode, taken: new Set<number>() } as const;
    this.#addToStroke(gesture, under);
    return gesture;
  }

  #addToStroke({ mode, taken }: { mode: MoveMode; taken: Set<number> }, under: Under): void {
    const group = mode === 'let-go' && this.take === 'side' ? this.#taking.groupAt(under) : undefined;
    for (const position of group?.vertices ?? under.positions) taken.add(position);
    this.#layers.hover(this.#parts.store.state.project, mode, { positions: [...taken] });
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
      gesture.hasMoved ||= !isStill(gesture.from, this.#pointer);
      if (!gesture.hasMoved) return;
      const { from, to } = gesture.plane.way(this.#pointer);
      const { along, plane } = gesture;
      gesture.by = translation(along ? plane.along(this.#pointer, along) : subtract(to, from));
    }
  }

  #beginTyped(kind: TypedTransform['kind']): void {
    const { handles, interaction, store } = this.#parts;
    const { active } = handles;
    if (!active) return;
    const { picking } = interaction;
    this.typed = new TypedMove(kind, active, { handles, picking, pointer: this.#pointer });
    store.set({});
  }

  #typedKey(event: KeyboardEvent): boolean {
    if (event.key === 'Escape') this.#dropTyped();
    else if (event.key === 'Enter') this.#keepTyped();
    else if (this.typed!.key(event.key)) this.#followTyped();
    else return false;
    return true;
  }

  #followTyped(): void {
    this.#soon(() => this.typed?.follow(this.#pointer));
  }

  #keepTyped(): void {
    const typed = this.typed!;
    this.typed = null;
    typed.keep(this.#pointer);
  }

  #dropTyped(): void {
    if (!this.typed) return;
    this.typed = null;
    this.#parts.handles.cancel();
    this.#show();
  }

  /** Where some positions look as they are seen; null without a mesh. */
  #outlook(positions: readonly number[]): Vec3 | null {
    const { project } = this.#parts.store.state;
    return project && outlook(shownPositions(project), solvedSourceTriangles(project.mesh), positions);
  }

  #axesOf(vertices: readonly number[]): readonly [number, number, number, number] | undefined {
    const normal = this.options.ownAxes ? this.#outlook(vertices) : null;
    return normal ? turnFromZ(normal) : undefined;
  }

  #show(): void {
    const { handles, store } = this.#parts;
    const { active, groups } = handles;
    const { project } = store.state;
    const surface = project && this.#parts.surface.of(project);
    handles.seekMirror();
    this.#layers.show(groups, active, handles.handles, { project, surface });
    if (!active || this.typed || this.#gesture?.kind === 'pull' || this.#isPushed(active)) this.#gizmo.hide();
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
