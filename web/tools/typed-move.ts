import { type HandleGroup, targetCenter } from '../../src/editor/handle-groups.ts';
import type { Affine } from '../../src/mesh/affine.ts';
import type { CanvasPointer } from '../../src/viewer/canvas-tool.ts';
import type { Picking } from '../../src/viewer/picking/picking.ts';
import type { Grip, HandleActions } from '../app/handle-actions.ts';
import { TypedTransform } from './typed-transform.ts';
import { ViewPlane } from './view-plane.ts';

/** A group that is moved by keys: G, R or S, then axes and numbers, or wherever the pointer goes. */
export class TypedMove {
  readonly #handles: HandleActions;
  readonly #transform: TypedTransform;
  readonly #grip: Grip;
  readonly #plane: ViewPlane;

  /** @param pointer null where there is none over the mesh */
  constructor(
    kind: TypedTransform['kind'],
    group: HandleGroup,
    {
      handles,
      picking,
      pointer,
    }: { handles: HandleActions; picking: Picking; pointer: CanvasPointer | null },
  ) {
    const pivot = targetCenter(handles.handles, group.vertices);
    this.#handles = handles;
    this.#transform = new TypedTransform(kind, pivot);
    this.#grip = handles.grip(group);
    this.#plane = new ViewPlane(picking, pointer ?? picking.project(pivot), pivot);
  }

  /** What it does, in words. */
  get sentence(): string {
    return this.#transform.sentence;
  }

  /** @returns whether it has used the key */
  key(key: string): boolean {
    return this.#transform.key(key);
  }

  follow(pointer: CanvasPointer | null): void {
    this.#handles.move(this.#grip, this.#movement(pointer));
  }

  keep(pointer: CanvasPointer | null): void {
    this.#handles.keep(this.#grip, this.#movement(pointer), this.sentence.split(' ')[0]!);
  }

  #movement(pointer: CanvasPointer | null): Affine {
    return this.#transform.movement(pointer ? this.#plane.way(pointer) : null);
  }
}
