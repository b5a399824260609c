import { Matrix4, Quaternion as Turn } from 'three';
import { restShapeOf } from '../../src/editor/project.ts';
import { zonotopeFaces } from '../../src/inputs/styles/zonotope.ts';
import type { Affine } from '../../src/mesh/affine.ts';
import { add, dot, scale, subtract, type Vec3 } from '../../src/mesh/vectors.ts';
import type { Quaternion } from '../../src/methods/values/rotation.ts';
import type { CanvasPointer } from '../../src/viewer/canvas-tool.ts';
import { Gizmo } from '../../src/viewer/gizmo.ts';
import type { Interaction } from '../../src/viewer/interaction.ts';
import type { CubeActions } from '../app/cube-actions.ts';
import type { PageStore } from '../app/page-state.ts';
import type { Tool } from './tool.ts';
import { ViewPlane } from './view-plane.ts';

export interface CubeParts {
  readonly store: PageStore;
  readonly interaction: Interaction;
  readonly cube: CubeActions;
  /** Runs something before the next picture. */
  readonly soon: (run: () => void) => void;
}

/** Where what the mesh is drawn to is shown: around it. */
interface Frame {
  readonly center: Vec3;
  /** File units for a row of length 1. */
  readonly unit: number;
}

type Gesture =
  | { readonly kind: 'turn'; readonly from: Quaternion; turn: Quaternion }
  | {
      readonly kind: 'stretch';
      readonly axis: 0 | 1 | 2;
      readonly from: Vec3;
      readonly plane: ViewPlane;
      /** Unit, in the file's frame, away from the middle. */
      readonly outward: Vec3;
      readonly frame: Frame;
      axes: Vec3;
    };

const color = '#2f7dd1';
const layerNames = ['cube-edges', 'cube-grips'] as const;
/** CSS pixels from the middle of a side within which it is taken. */
const grabRadius = 22;

/** Turns what the mesh is drawn to by rings around it, and stretches the cube by pulling its sides. */
export class TurnCube implements Tool {
  readonly #parts: CubeParts;
  readonly #gizmo: Gizmo;
  #gesture: Gesture | null = null;
  #pointer: CanvasPointer | null = null;
  #isScheduled = false;
  #unlisten: (() => void) | null = null;
  #shown: readonly unknown[] = [];
  /** The last box that was measured: pointing asks for it again and again, and a large mesh takes its time. */
  #box: { readonly rest: unknown; readonly members: unknown; readonly box: Box } | null = null;

  constructor(parts: CubeParts) {
    this.#parts = parts;
    this.#gizmo = new Gizmo(parts.interaction.viewer);
    this.#gizmo.mode = 'rotate';
  }

  enter(): void {
    this.#unlisten = this.#parts.store.subscribe(() => this.#show());
    this.#shown = [];
    this.#show();
  }

  leave(): void {
    this.#unlisten?.();
    this.#unlisten = null;
    this.#gizmo.hide();
    for (const name of layerNames) this.#parts.interaction.layers.set(name, null);
  }

  hover(pointer: CanvasPointer | null): void {
    this.#pointer = pointer;
    const side = pointer && !this.#gizmo.hover(pointer) ? this.#sideAt(pointer) : null;
    this.#drawGrips(side);
    this.#parts.interaction.viewer.invalidate();
  }

  press(pointer: CanvasPointer): boolean {
    this.#pointer = pointer;
    const { cube, interaction } = this.#parts;
    const side = this.#sideAt(pointer);
    if (side) {
      const at = this.#sidePlace(side);
      const plane = new ViewPlane(interaction.picking, pointer, at);
      const frame = this.#frame()!;
      const outward = this.#turned(side);
      const axis = side.findIndex((part) => part !== 0) as 0 | 1 | 2;
      this.#gesture = { kind: 'stretch', axis, from: cube.axes, plane, outward, frame, axes: cube.axes };
      return true;
    }
    if (!cube.isTurnable || !this.#gizmo.press(pointer)) return false;
    this.#gesture = { kind: 'turn', from: cube.orientation, turn: [0, 0, 0, 1] };
    return true;
  }

  move(pointer: CanvasPointer): void {
    this.#pointer = pointer;
    if (this.#isScheduled) return;
    this.#isScheduled = true;
    this.#parts.soon(() => {
      this.#isScheduled = false;
      this.#follow(false);
    });
  }

  release(pointer: CanvasPointer): void {
    this.#pointer = pointer;
    this.#follow(true);
    if (this.#gesture?.kind === 'turn') this.#gizmo.release();
    this.#gesture = null;
    this.#show();
  }

  cancel(): void {
    if (this.#gesture?.kind === 'turn') this.#gizmo.release();
    if (this.#gesture) this.#parts.cube.cancel();
    this.#gesture = null;
    this.#show();
  }

  #follow(isDone: boolean): void {
    const gesture = this.#gesture;
    if (!gesture || !this.#pointer) return;
    const { cube } = this.#parts;
    if (gesture.kind === 'turn') {
      const by = this.#gizmo.move(this.#pointer);
      if (by) gesture.turn = quaternionOf(by);
      cube.turn(gesture.from, gesture.turn, isDone);
    } else {
      gesture.axes = stretched(gesture, this.#pointer);
      cube.stretch(gesture.axes, isDone);
    }
  }

  /** Around the mesh, or around the region whose cube is turned. */
  #frame(): Frame | null {
    const { cube, store } = this.#parts;
    const { project } = store.state;
    const rest = project && restShapeOf(project, project.active);
    if (!project || !rest) return null;
    const { region } = cube;
    const positions = region === null ? null : cube.regions[region]!.vertices;
    const { center, reach } = this.#boxOf(rest, positions ?? project.mesh.triangles);
    const longest = Math.max(...cube.rows.map((row) => Math.hypot(...row)), 1e-3);
    const gesture = this.#gesture?.kind === 'stretch' ? this.#gesture.frame : null;
    return gesture ?? { center, unit: (1.75 * reach) / longest };
  }

  #boxOf(rest: Float64Array, members: ArrayLike<number>): Box {
    if (this.#box?.rest !== rest || this.#box.members !== members)
      this.#box = { rest, members, box: boxOf(rest, members) };
    return this.#box.box;
  }

  #show(): void {
    const { cube, store, interaction } = this.#parts;
    const { project } = store.state;
    const frame = project && cube.isTurnable ? this.#frame() : null;
    if (!frame) {
      this.#gizmo.hide();
      for (const name of layerNames) interaction.layers.set(name, null);
      return;
    }
    const { orientation, rows } = cube;
    const now = [
      project?.mesh,
      cube.region,
      cube.isBox,
      ...orientation,
      ...rows.flat(),
      ...frame.center,
      frame.unit,
    ];
    if (now.length !== this.#shown.length || now.some((value, k) => value !== this.#shown[k])) {
      this.#shown = now;
      this.#drawCube(frame);
      this.#drawGrips(null);
    }
    if (this.#gesture?.kind !== 'turn') this.#gizmo.show(frame.center, orientation);
  }

  #drawCube(frame: Frame): void {
    const places = zonotopeFaces(this.#parts.cube.rows).flatMap(({ corners }) => {
      const there = corners.map((corner) => add(frame.center, scale(this.#turned(corner), frame.unit)));
      return there.flatMap((corner, k) => [...corner, ...there[(k + 1) % there.length]!]);
    });
    this.#parts.interaction.layers.set('cube-edges', {
      kind: 'lines',
      places,
      width: 1.5,
      color,
      depth: 'faint-behind',
    });
  }

  /** A dot on each side that can be pulled, the one that would be taken larger. */
  #drawGrips(chosen: Vec3 | null): void {
    const { cube, interaction } = this.#parts;
    const frame = cube.isTurnable && cube.isBox && cube.region === null ? this.#frame() : null;
    if (!frame) {
      interaction.layers.set('cube-grips', null);
      return;
    }
    const arms = sides.map((side) => {
      const at = this.#sidePlace(side);
      const share = side === chosen ? 0.1 : 0.06;
      return { at, tip: add(at, scale(this.#turned(side), frame.unit * share * Math.max(...cube.axes))) };
    });
    interaction.layers.set('cube-grips', {
      kind: 'arrows',
      from: arms.flatMap(({ at }) => at),
      to: arms.flatMap(({ tip }) => tip),
      width: chosen ? 4 : 2.5,
      color,
      depth: 'in-front',
    });
  }

  #sideAt({ x, y }: CanvasPointer): Vec3 | null {
    const { cube, interaction } = this.#parts;
    if (!cube.isTurnable || !cube.isBox || cube.region !== null) return null;
    let found: Vec3 | null = null;
    let least = grabRadius;
    for (const side of sides) {
      const place = interaction.picking.project(this.#sidePlace(side));
      const away = Math.hypot(place.x - x, place.y - y);
      if (away < least) [found, least] = [side, away];
    }
    return found;
  }

  /** The middle of a side, in the file's frame. */
  #sidePlace(side: Vec3): Vec3 {
    const { center, unit } = this.#frame()!;
    const { axes } = this.#parts.cube;
    const half: Vec3 = [(side[0] * axes[0]) / 2, (side[1] * axes[1]) / 2, (side[2] * axes[2]) / 2];
    return add(center, scale(this.#turned(half), unit));
  }

  #turned(vector: Vec3): Vec3 {
    const [x, y, z, w] = this.#parts.cube.orientation;
    const { elements: e } = new Matrix4().makeRotationFromQuaternion(new Turn(x, y, z, w).normalize());
    return [
      e[0]! * vector[0] + e[4]! * vector[1] + e[8]! * vector[2],
      e[1]! * vector[0] + e[5]! * vector[1] + e[9]! * vector[2],
      e[2]! * vector[0] + e[6]! * vector[1] + e[10]! * vector[2],
    ];
  }
}

const sides: readonly Vec3[] = [
  [1, 0, 0],
  [-1, 0, 0],
  [0, 1, 0],
  [0, -1, 0],
  [0, 0, 1],
  [0, 0, -1],
];

function stretched(gesture: Extract<Gesture, { kind: 'stretch' }>, pointer: CanvasPointer): Vec3 {
  const { from, to, toEye } = gesture.plane.way(pointer);
  const seen = subtract(gesture.outward, scale(toEye, dot(gesture.outward, toEye)));
  const along = dot(subtract(to, from), seen) / Math.max(0.04, dot(seen, seen));
  const axes: [number, number, number] = [...gesture.from];
  // A side moves half as far as the edge grows.
  const pulled = axes[gesture.axis] + (2 * along) / gesture.frame.unit;
  axes[gesture.axis] = Math.round(100 * Math.min(10, Math.max(0, pulled))) / 100;
  return axes;
}

function quaternionOf({ rows: [a, b, c] }: Affine): Quaternion {
  const matrix = new Matrix4().set(...a, 0, ...b, 0, ...c, 0, 0, 0, 0, 1);
  return new Turn().setFromRotationMatrix(matrix).toArray() as unknown as Quaternion;
}

/** The middle of the box of some positions, and half of its longest side. */
interface Box {
  readonly center: Vec3;
  readonly reach: number;
}

function boxOf(shape: ArrayLike<number>, positions: ArrayLike<number>): Box {
  const low: [number, number, number] = [Infinity, Infinity, Infinity];
  const high: [number, number, number] = [-Infinity, -Infinity, -Infinity];
  for (let k = 0; k < positions.length; k++)
    for (const axis of [0, 1, 2] as const) {
      const value = shape[3 * positions[k]! + axis]!;
      low[axis] = Math.min(low[axis], value);
      high[axis] = Math.max(high[axis], value);
    }
  const size = subtract(high, low);
  return { center: scale(add(low, high), 0.5), reach: Math.max(...size) / 2 };
}
