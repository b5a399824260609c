import { type Matrix4, Object3D, Quaternion, Vector3 } from 'three';
import { TransformControls } from 'three/examples/jsm/controls/TransformControls.js';
import type { Affine } from '../mesh/affine.ts';
import { row, type Vec3 } from '../mesh/vectors.ts';
import type { CanvasPointer } from './canvas-tool.ts';
import type { Viewer } from './viewer.ts';

export type GizmoMode = 'translate' | 'rotate' | 'scale';

/** What movements snap to while Ctrl is held: radians, factors, and the frame's units, of which half a diagonal is 1. */
const snaps = { angle: Math.PI / 12, scale: 0.1, translation: 0.05 };

/** Axes, rings and squares by which something is moved, turned and stretched. Tools pass it their pointers and get movements. */
export class Gizmo {
  readonly #viewer: Viewer;
  readonly #controls: TransformControls;
  readonly #pivot = new Object3D();
  #start: Matrix4 | null = null;

  constructor(viewer: Viewer) {
    this.#viewer = viewer;
    const { camera, overlay, gizmos } = viewer.space;
    this.#controls = new TransformControls(camera);
    // Axes of its own are the pivot's, which are the file's unless it is told otherwise.
    this.#controls.setSpace('local');
    this.#controls.setSize(0.85);
    overlay.add(this.#pivot);
    gizmos.add(this.#controls.getHelper());
    this.#controls.addEventListener('change', viewer.invalidate);
  }

  get isShown(): boolean {
    return this.#controls.object !== undefined;
  }

  get mode(): GizmoMode {
    return this.#controls.mode as GizmoMode;
  }

  set mode(mode: GizmoMode) {
    this.#controls.setMode(mode);
  }

  /** @param center in the file's frame   @param axes a quaternion x, y, z, w; default the file's own axes */
  show(center: Vec3, axes: readonly [number, number, number, number] = [0, 0, 0, 1]): void {
    const frame = this.#viewer.space.surface?.frame;
    if (!frame || this.#start) return;
    this.#pivot.position.fromArray(center.map((value, k) => (value - frame.center[k]!) * frame.scale));
    this.#pivot.quaternion.copy(new Quaternion(...axes));
    this.#pivot.scale.setScalar(1);
    this.#pivot.updateMatrix();
    if (!this.isShown) this.#controls.attach(this.#pivot);
    this.#viewer.invalidate();
  }

  hide(): void {
    this.#start = null;
    if (this.isShown) this.#controls.detach();
    this.#viewer.invalidate();
  }

  /** @returns whether a press here would be the gizmo's */
  hover(pointer: CanvasPointer): boolean {
    if (!this.isShown || this.#start) return false;
    // What it picks by lies where it was drawn last.
    this.#viewer.space.camera.updateMatrixWorld();
    this.#pivot.updateWorldMatrix(true, false);
    this.#controls.getHelper().updateMatrixWorld(true);
    this.#controls.pointerHover(this.#place(pointer, -1));
    return this.#controls.axis !== null;
  }

  /** @returns whether the gesture is the gizmo's */
  press(pointer: CanvasPointer): boolean {
    if (!this.hover(pointer)) return false;
    this.#controls.pointerDown(this.#place(pointer, 0));
    if (!this.#controls.dragging) return false;
    this.#start = this.#matrix();
    return true;
  }

  /** The movement since the press, in the file's frame. */
  move(pointer: CanvasPointer): Affine | null {
    if (!this.#start) return null;
    const { frame } = this.#viewer.space.surface!;
    this.#controls.setRotationSnap(pointer.ctrl ? snaps.angle : null);
    this.#controls.setScaleSnap(pointer.ctrl ? snaps.scale : null);
    this.#controls.setTranslationSnap(pointer.ctrl ? snaps.translation : null);
    this.#controls.pointerMove(this.#place(pointer, -1));
    return this.#affine(this.#matrix().multiply(this.#start.clone().invert()), frame);
  }

  release(): void {
    this.#start = null;
    this.#controls.pointerUp(null as never);
  }

  dispose(): void {
    this.hide();
    this.#pivot.removeFromParent();
    this.#controls.getHelper().removeFromParent();
    this.#controls.dispose();
  }

  #matrix(): Matrix4 {
    this.#pivot.updateMatrix();
    return this.#pivot.matrix.clone();
  }

  #affine(matrix: Matrix4, { center, scale }: { center: Vec3; scale: number }): Affine {
    const e = matrix.elements;
    const rows = [0, 1, 2].map((r) => [e[r]!, e[r + 4]!, e[r + 8]!] as const) as unknown as Affine['rows'];
    const middle = new Vector3(...center);
    const offset = rows.map((line, r) => {
      const turned = middle.dot(new Vector3(...line));
      return e[12 + r]! / scale + center[r]! - turned;
    });
    return { rows, offset: row(offset, 0) };
  }

  #place({ x, y }: CanvasPointer, button: number): PointerEvent {
    const { clientWidth: width, clientHeight: height } = this.#viewer.canvas;
    const place = { x: (2 * x) / width - 1, y: 1 - (2 * y) / height, button };
    // The controls only read these.
    return place as unknown as PointerEvent;
  }
}
