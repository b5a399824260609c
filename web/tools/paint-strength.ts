import { activeStep, restShapeOf } from '../../src/editor/project.ts';
import { sampleSphere } from '../../src/inputs/fields/sphere-field.ts';
import { diagonalOf } from '../../src/mesh/extent.ts';
import type { Mesh } from '../../src/mesh/mesh.ts';
import { add, scale, type Vec3 } from '../../src/mesh/vectors.ts';
import type { SphereField } from '../../src/methods/values/sphere-field.ts';
import {
  type FieldBrush,
  type FieldOperation,
  FieldStroke,
  SurfaceCanvas,
  unpainted,
} from '../../src/painting/index.ts';
import type { MirrorMap, SurfacePoint } from '../../src/selection/index.ts';
import type { CanvasPointer } from '../../src/viewer/canvas-tool.ts';
import type { Interaction } from '../../src/viewer/interaction.ts';
import type { Hit } from '../../src/viewer/picking/picking.ts';
import { Mirror } from '../app/mirrors.ts';
import type { PageStore } from '../app/page-state.ts';
import type { Selectable } from '../app/selectable.ts';
import type { StrengthActions } from '../app/strength-actions.ts';
import { BallBrush, evenField } from './ball-brush.ts';
import { across, brushRing } from './brush-ring.ts';
import { StrengthView } from './strength-view.ts';
import type { Tool } from './tool.ts';

/** What pressing does: a brush, or a pipette that takes the strength there for `set`. */
export type PaintMode = FieldOperation | 'pick';

export interface PaintOptions {
  readonly mode: PaintMode;
  /** Radius of the brush as a share of the mesh's diagonal; on the ball, of {@link ballReach}. */
  readonly size: number;
  readonly strength: number;
  readonly hardness: number;
  /** What `set` brings strength to. */
  readonly value: number;
  /** What is painted on one side is painted on the other. */
  readonly mirror: boolean;
}

export interface PaintParts {
  readonly store: PageStore;
  readonly interaction: Interaction;
  readonly strength: StrengthActions;
  readonly surface: Selectable;
  /** Runs something before the next picture. */
  readonly soon: (run: () => void) => void;
}

type Gesture =
  | { readonly kind: 'surface'; readonly stroke: FieldStroke<SurfacePoint>; at: CanvasPointer }
  | { readonly kind: 'ball' }
  | { readonly kind: 'pick' };

/** Angle on the ball, in radians, for a size of 1. */
const ballReach = 4.4;
/** Most places that are looked at between two sights of the pointer. */
const mostBetween = 12;

/** Paints how strong the style is: on the surface, and by direction on a ball that stands beside. */
export class PaintStrength implements Tool {
  options: PaintOptions = {
    ...{ mode: 'subtract', size: 0.08, strength: 0.5, hardness: 0.4, value: 0.5, mirror: false },
  };
  readonly cursor = 'crosshair';
  readonly #parts: PaintParts;
  readonly #view: StrengthView;
  #gesture: Gesture | null = null;
  #isScheduled = false;
  /** The gesture that is under way has been shown. */
  #isPreviewed = false;
  /** Of the mesh that it was found for. */
  readonly #mirror = new Mirror();
  readonly #ball = new BallBrush();
  #unlisten: (() => void) | null = null;
  /** Where the face looks that a pointer is over, for the ball to show. */
  #pointed: Vec3 | null = null;
  /** The ball is to be drawn anew. */
  onBall: () => void = () => {};

  constructor(parts: PaintParts) {
    this.#parts = parts;
    this.#view = new StrengthView(parts.interaction.viewer);
  }

  enter(): void {
    const { store } = this.#parts;
    // Colours are strength now.
    if (store.state.look.overlay !== 'none') store.set({ look: { ...store.state.look, overlay: 'none' } });
    this.#unlisten = store.subscribe(() => this.#show());
    this.#show();
  }

  leave(): void {
    this.#unlisten?.();
    this.#unlisten = null;
    this.#view.hide();
    this.#ring(null);
    this.light(null);
  }

  set(change: Partial<PaintOptions>): void {
    this.options = { ...this.options, ...change };
    this.#parts.store.set({});
  }

  /** What is on the ball now: the stroke that is being painted, else that of the step; null where nobody has painted. */
  get field(): SphereField | null {
    return this.#ball.field ?? this.#strength.field;
  }

  get pointed(): Vec3 | null {
    return this.#pointed;
  }

  /** The radius of the brush on the ball, in radians. */
  get ballRadius(): number {
    return ballReach * this.options.size;
  }

  get isOnBall(): boolean {
    return this.#gesture?.kind === 'ball';
  }

  hover(pointer: CanvasPointer | null): void {
    this.#point(pointer && this.#parts.interaction.picking.pick(pointer));
  }

  press(pointer: CanvasPointer): boolean {
    const hit = this.#parts.interaction.picking.pick(pointer);
    const { project } = this.#parts.store.state;
    const surface = this.#surface();
    if (!hit || !project || !surface || !this.#strength.isOnSurface) return false;
    if (this.options.mode === 'pick' || pointer.alt) {
      this.#gesture = { kind: 'pick' };
      this.#pick(hit);
      return true;
    }
    const base = this.#strength.shares ?? new Float64Array(surface.topology.vertices).fill(unpainted);
    const canvas = new SurfaceCanvas(surface, this.#mirrorOf(project.mesh));
    const radius = this.options.size * this.#diagonal();
    const stroke = new FieldStroke(canvas, base, this.#brush(radius, pointer));
    this.#gesture = { kind: 'surface', stroke, at: pointer };
    this.#touch(stroke, hit, pointer.pressure);
    return true;
  }

  move(pointer: CanvasPointer): void {
    const gesture = this.#gesture;
    const { picking } = this.#parts.interaction;
    if (gesture?.kind !== 'surface') {
      const hit = picking.pick(pointer);
      if (hit && gesture) this.#pick(hit);
      return;
    }
    let last: Hit | null = null;
    for (const place of between(gesture.at, pointer, this.#spacing(gesture.at))) {
      last = picking.pick(place);
      if (last) this.#touch(gesture.stroke, last, pointer.pressure);
    }
    gesture.at = pointer;
    this.#point(last);
  }

  release(): void {
    const gesture = this.#gesture;
    this.#gesture = null;
    this.#isPreviewed = false;
    if (gesture?.kind === 'surface') this.#strength.commit({ shares: gesture.stroke.values });
    this.#show();
  }

  cancel(): void {
    this.#gesture = null;
    this.#ball.end();
    // What has not been shown yet is not there to be taken back.
    if (this.#isPreviewed) this.#strength.cancel();
    this.#isPreviewed = false;
    this.#view.forget();
    this.#show();
  }

  /** All of the surface, or of the ball, gets one strength; 1 is as if nobody had painted. */
  fill(where: 'shares' | 'field', value: 0 | 1): void {
    const count = this.#surface()?.topology.vertices;
    if (count === undefined) return;
    const label = value === 1 ? 'Full strength' : 'No strength';
    if (value === 1) this.#strength.commit({ [where]: null }, label);
    else if (where === 'shares') this.#strength.commit({ shares: new Float64Array(count) }, label);
    else this.#strength.commit({ field: evenField(0) }, label);
  }

  beginBall(direction: Vec3, pointer: Pick<CanvasPointer, 'pressure' | 'shift' | 'ctrl' | 'alt'>): void {
    const { field, isOnBall } = this.#strength;
    if (!isOnBall) return;
    if (this.options.mode === 'pick' || pointer.alt) {
      this.set({ mode: 'set', value: field ? sampleSphere(field, direction) : unpainted });
      return;
    }
    this.#ball.begin(field, this.#brush(this.ballRadius, pointer), this.options.mirror);
    this.#gesture = { kind: 'ball' };
    this.moveBall(direction, pointer.pressure);
  }

  moveBall(direction: Vec3, pressure: number): void {
    if (!this.isOnBall) return;
    this.#ball.touch(direction, pressure);
    this.#soon();
  }

  endBall(): void {
    if (!this.isOnBall) return;
    this.#gesture = null;
    this.#isPreviewed = false;
    this.#strength.commit({ field: this.#ball.end() });
    this.#show();
  }

  /** Lights the faces that look where the brush is on the ball. */
  light(direction: Vec3 | null): void {
    const { layers, viewer } = this.#parts.interaction;
    const { surface } = viewer.space;
    const corners =
      direction && surface && this.#view.isShown
        ? this.#view.facesTowards(direction, this.ballRadius, surface.triangles)
        : null;
    layers.set(
      'lit',
      corners && { kind: 'faces', corners, color: '#ffd54a', opacity: 0.55, depth: 'hidden-behind' },
    );
  }

  get #strength(): StrengthActions {
    return this.#parts.strength;
  }

  #surface() {
    const { project } = this.#parts.store.state;
    return project && this.#parts.surface.of(project);
  }

  #diagonal(): number {
    return diagonalOf(this.#parts.store.state.project!.mesh);
  }

  /** Shift smooths, Ctrl takes away what is added and adds what is taken away. */
  #brush(radius: number, { shift, ctrl }: Pick<CanvasPointer, 'shift' | 'ctrl'>): FieldBrush {
    const { mode, strength, hardness, value } = this.options;
    const opposite = { add: 'subtract', subtract: 'add' } as const;
    let operation: FieldOperation = mode === 'pick' ? 'set' : mode;
    if (shift) operation = 'smooth';
    else if (ctrl && (operation === 'add' || operation === 'subtract')) operation = opposite[operation];
    return { operation, radius, strength, hardness, value };
  }

  #touch(stroke: FieldStroke<SurfacePoint>, hit: Hit, pressure: number): void {
    const weights = hit.weights as SurfacePoint['weights'];
    const touched = stroke.touch({ face: hit.face, weights }, pressure);
    if (touched.length === 0) return;
    this.#view.touch(touched, stroke.values);
    this.#soon();
  }

  #pick({ face, weights }: Hit): void {
    const shares = this.#strength.shares;
    const corners = this.#surface()!.topology.triangles.subarray(3 * face, 3 * face + 3);
    const value = shares
      ? weights.reduce((sum, weight, k) => sum + weight * shares[corners[k]!]!, 0)
      : unpainted;
    this.set({ mode: 'set', value: Math.min(1, Math.max(0, value)) });
  }

  /** How far the pointer may go between two touches, in CSS pixels. */
  #spacing(pointer: CanvasPointer): number {
    const { picking } = this.#parts.interaction;
    const hit = picking.pick(pointer);
    if (!hit) return 16;
    const beside = add(hit.point, scale(across(hit.normal), this.options.size * this.#diagonal()));
    const place = picking.project(beside);
    return Math.max(4, Math.hypot(place.x - pointer.x, place.y - pointer.y) / 3);
  }

  /** At most one preview a picture: pointers are faster than screens. */
  #soon(): void {
    if (this.#isScheduled) return;
    this.#isScheduled = true;
    this.#parts.soon(() => {
      this.#isScheduled = false;
      const gesture = this.#gesture;
      this.#isPreviewed = gesture?.kind === 'surface' || gesture?.kind === 'ball';
      if (gesture?.kind === 'surface') this.#strength.preview({ shares: gesture.stroke.values.slice() });
      if (gesture?.kind === 'ball') this.#strength.preview({ field: this.#ball.field });
    });
  }

  #point(hit: Hit | null): void {
    const isKnown = hit !== null && this.#view.isShown;
    this.#pointed = isKnown ? this.#view.normalOf(hit.face) : null;
    this.#ring(hit);
    this.onBall();
  }

  #ring(hit: Hit | null): void {
    const { layers } = this.#parts.interaction;
    const isShown = hit && this.options.mode !== 'pick' && this.#strength.isOnSurface;
    layers.set('brush', isShown ? brushRing(hit, this.options.size * this.#diagonal()) : null);
  }

  /** The mirror of this mesh, where it is wanted and known. */
  #mirrorOf(mesh: Mesh): MirrorMap | null {
    return this.options.mirror ? this.#mirror.of(mesh, () => {}) : null;
  }

  /** Brings colours and ball to what the project has. */
  #show(): void {
    const { project, look } = this.#parts.store.state;
    const rest = project && restShapeOf(project, activeStep(project).id);
    if (!project || !rest || !this.#strength.isOnSurface) {
      this.#view.hide();
      return;
    }
    // Someone wants to see other colours now.
    if (look.overlay !== 'none') {
      this.#view.forget();
      return;
    }
    this.#surface(); // it is made meanwhile
    this.#mirrorOf(project.mesh); // so is this
    if (this.#gesture?.kind === 'surface') return;
    this.#view.show({ mesh: project.mesh, rest, shares: this.#strength.shares, field: this.field });
    this.onBall();
  }
}

/** Places on the way of a pointer, itself the last. */
function between(from: CanvasPointer, to: CanvasPointer, spacing: number): Pick<CanvasPointer, 'x' | 'y'>[] {
  const steps = Math.ceil(Math.hypot(to.x - from.x, to.y - from.y) / spacing);
  const count = Math.min(mostBetween, Math.max(1, steps));
  return Array.from({ length: count }, (_, k) => {
    const share = (k + 1) / count;
    return { x: from.x + share * (to.x - from.x), y: from.y + share * (to.y - from.y) };
  });
}
