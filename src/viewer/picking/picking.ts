import { DoubleSide, type Ray, Raycaster, Vector2, Vector3 } from 'three';
import type { MeshBVH } from 'three-mesh-bvh';
import { doubledAreaVector, row, subtract, unit, type Vec3 } from '../../mesh/vectors.ts';
import type { CanvasPointer } from '../canvas-tool.ts';
import type { Surface } from '../surface.ts';
import type { ShapeChange, Viewer } from '../viewer.ts';
import { type TreeAnswer, unpack } from './tree.ts';
import { startTreeThread, type TreeThread } from './tree-thread.ts';

/** The place of the drawn surface that a pointer is over. */
export interface Hit {
  /** Of the drawn faces (`solvedSourceTriangles` of the mesh). */
  readonly face: number;
  /** Positions of the file. */
  readonly corners: readonly [number, number, number];
  /** How much each corner has of the place; their sum is 1. */
  readonly weights: Vec3;
  /** In the file's frame and units, of the shape as it is drawn. */
  readonly point: Vec3;
  /** Of the face, unit, in the file's axes; it looks at the one who looks. */
  readonly normal: Vec3;
}

/** A place on the canvas, in CSS pixels; `depth` rises from −1 near to 1 far, what lies beyond is not to be seen. */
export interface CanvasPlace {
  readonly x: number;
  readonly y: number;
  readonly depth: number;
}

/** A shape that moves is not followed; the tree is fitted when it has rested for as long, in milliseconds. */
const rest = 60;

/**
 * Finds what a pointer is over, and what is near a place of the surface. Its tree of boxes is made in another thread, from the first
 * {@link want} on, and fitted to the shape when that has moved; until then it is the one of the shape before, and there is none for
 * the first moment of a mesh.
 */
export class Picking {
  readonly #viewer: Viewer;
  readonly #startThread: () => TreeThread;
  readonly #unlisten: () => void;
  readonly #raycaster = new Raycaster();
  #thread: TreeThread | null = null;
  #surface: Surface | null = null;
  #tree: MeshBVH | null = null;
  #isWanted = false;
  /** Numbers what the thread is asked; an answer is of the shape at that time. */
  #turn = 0;
  /** The turn in which the mesh that is shown was first sent; 0 before. */
  #meshTurn = 0;
  #answered = 0;
  #isStale = false;
  #timer: ReturnType<typeof setTimeout> | undefined;
  #waiting: (() => void)[] = [];

  constructor(viewer: Viewer, startThread: () => TreeThread = startTreeThread) {
    this.#viewer = viewer;
    this.#startThread = startThread;
    this.#unlisten = viewer.onShape((change) => this.#follow(change));
    this.#surface = viewer.space.surface;
  }

  /** Has the tree made and kept from now on. */
  want(): void {
    if (this.#isWanted) return;
    this.#isWanted = true;
    if (this.#surface) this.#build();
  }

  /** Whether what is under a pointer can be told of the mesh that is shown. */
  get isReady(): boolean {
    return this.#tree !== null;
  }

  /** Resolves when the tree fits what is drawn. */
  ready(): Promise<void> {
    this.want();
    if (this.#isStale) this.#refit();
    if (!this.#surface || this.#answered === this.#turn) return Promise.resolve();
    return new Promise((resolve) => this.#waiting.push(resolve));
  }

  /** What is seen under a pointer; null beside the mesh. */
  pick(pointer: Pick<CanvasPointer, 'x' | 'y'>): Hit | null {
    return this.#hit(this.#rayThrough(pointer));
  }

  /** The ray that leads from the eye through a pointer, in the file's frame and units. */
  ray(pointer: Pick<CanvasPointer, 'x' | 'y'>): { readonly origin: Vec3; readonly direction: Vec3 } {
    const ray = this.#rayThrough(pointer);
    return { origin: this.#toFile(ray.origin), direction: ray.direction.toArray() as Vec3 };
  }

  /** Where a point of the file's space is on the canvas. */
  project(point: Vec3): CanvasPlace {
    const { camera, overlay } = this.#viewer.space;
    const { clientWidth: width, clientHeight: height } = this.#viewer.canvas;
    const place = overlay.localToWorld(this.#toView(point)).project(camera);
    return { x: ((place.x + 1) * width) / 2, y: ((1 - place.y) * height) / 2, depth: place.z };
  }

  dispose(): void {
    this.#unlisten();
    clearTimeout(this.#timer);
    this.#thread?.end();
    this.#tree = this.#surface = null;
    this.#wake();
  }

  #follow(change: ShapeChange): void {
    const { surface } = this.#viewer.space;
    if (change === 'mesh') {
      this.#surface = surface;
      this.#tree = null;
      if (this.#isWanted && surface) this.#build();
    } else if (this.#meshTurn > 0) {
      this.#isStale = true;
      clearTimeout(this.#timer);
      this.#timer = setTimeout(() => this.#refit(), rest);
    }
  }

  #build(): void {
    if (!this.#thread) {
      this.#thread = this.#startThread();
      this.#thread.onAnswer = (answer) => this.#take(answer);
    }
    this.#isStale = false;
    this.#meshTurn = ++this.#turn;
    const { drawn, triangles } = this.#surface!;
    const positions = drawn.slice() as Float32Array<ArrayBuffer>;
    this.#thread.ask({ type: 'build', turn: this.#turn, positions, triangles: triangles.slice() });
  }

  #refit(): void {
    clearTimeout(this.#timer);
    if (!this.#surface || !this.#thread) return;
    this.#isStale = false;
    const positions = this.#surface.drawn.slice() as Float32Array<ArrayBuffer>;
    this.#thread.ask({ type: 'refit', turn: ++this.#turn, positions });
  }

  /** An answer for a mesh that is not shown any more is not used; the one that is shown was asked for after it. */
  #take({ turn, tree }: TreeAnswer): void {
    if (turn < this.#meshTurn || !this.#surface) return;
    this.#tree = unpack(tree, this.#surface.geometry);
    this.#answered = turn;
    if (turn === this.#turn) this.#wake();
  }

  #wake(): void {
    for (const resolve of this.#waiting.splice(0)) resolve();
  }

  #hit(ray: Ray): Hit | null {
    const surface = this.#surface;
    const found = surface && this.#tree?.raycastFirst(ray, DoubleSide);
    if (!surface || !found) return null;
    const face = found.faceIndex ?? 0;
    const corners = [...surface.triangles.subarray(3 * face, 3 * face + 3)] as [number, number, number];
    const [a, b, c] = corners.map((corner) => row(surface.drawn, corner)) as [Vec3, Vec3, Vec3];
    const outward = unit(doubledAreaVector(a, b, c));
    const isSeenFromBehind = ray.direction.dot(new Vector3(...outward)) > 0;
    return {
      face,
      corners,
      weights: weightsOf(found.point.toArray() as Vec3, a, b, c),
      point: this.#toFile(found.point),
      normal: isSeenFromBehind ? subtract([0, 0, 0], outward) : outward,
    };
  }

  /** In view units, in the file's axes. */
  #rayThrough({ x, y }: Pick<CanvasPointer, 'x' | 'y'>): Ray {
    const { camera, overlay } = this.#viewer.space;
    const { clientWidth: width, clientHeight: height } = this.#viewer.canvas;
    this.#raycaster.setFromCamera(new Vector2((2 * x) / width - 1, 1 - (2 * y) / height), camera);
    overlay.updateWorldMatrix(true, false);
    return this.#raycaster.ray.clone().applyMatrix4(overlay.matrixWorld.clone().invert());
  }

  #toFile(point: Vector3): Vec3 {
    const { center, scale } = this.#viewer.space.surface!.frame;
    return [point.x / scale + center[0], point.y / scale + center[1], point.z / scale + center[2]];
  }

  #toView([x, y, z]: Vec3): Vector3 {
    const { center, scale } = this.#viewer.space.surface!.frame;
    return new Vector3((x - center[0]) * scale, (y - center[1]) * scale, (z - center[2]) * scale);
  }
}

/** Barycentric weights of a point of a triangle; thirds where the triangle has no area. */
function weightsOf(p: Vec3, a: Vec3, b: Vec3, c: Vec3): Vec3 {
  const areas = [doubledAreaVector(p, b, c), doubledAreaVector(a, p, c), doubledAreaVector(a, b, p)].map(
    (vector) => Math.hypot(...vector),
  );
  const sum = areas[0]! + areas[1]! + areas[2]!;
  return sum > 0 ? [areas[0]! / sum, areas[1]! / sum, areas[2]! / sum] : [1 / 3, 1 / 3, 1 / 3];
}
