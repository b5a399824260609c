import { Group, LineSegments, Mesh as MeshObject } from 'three';
import type { Mesh } from '../mesh/mesh.ts';
import type { Finish } from './finish.ts';
import { Surface } from './surface.ts';

export type Shading = 'smooth' | 'flat' | 'wire';

/** A mesh in one shape, as an object of the scene. It has the file's axes, in view units. */
export class Body {
  readonly surface: Surface;
  readonly object = new Group();
  readonly #finish: Finish;
  readonly #faces: MeshObject;
  #lines: LineSegments | null = null;

  constructor(mesh: Mesh, finish: Finish) {
    this.surface = new Surface(mesh);
    this.#finish = finish;
    this.#faces = new MeshObject(this.surface.geometry, finish.clay);
    this.#faces.frustumCulled = false;
    this.#faces.castShadow = true;
    const { facing } = this.surface;
    this.#faces.receiveShadow = facing !== 'neither';
    finish.face(facing);
    this.object.add(this.#faces);
  }

  shade(shading: Shading): void {
    this.#faces.material = shading === 'smooth' ? this.#finish.clay : this.#finish.facets;
    if (shading === 'wire' && !this.#lines) {
      this.#lines = new LineSegments(this.surface.edges(), this.#finish.ink);
      this.#lines.frustumCulled = false;
      this.object.add(this.#lines);
    }
    if (this.#lines) this.#lines.visible = shading === 'wire';
  }

  dispose(): void {
    this.object.removeFromParent();
    this.surface.dispose();
  }
}
