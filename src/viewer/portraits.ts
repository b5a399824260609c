import {
  BufferAttribute,
  type BufferGeometry,
  DoubleSide,
  Mesh as MeshObject,
  MeshStandardMaterial,
  PerspectiveCamera,
  Scene,
  WebGLRenderer,
} from 'three';
import type { Mesh } from '../mesh/mesh.ts';
import { Stage, type StageTheme } from './stage.ts';
import { Surface } from './surface.ts';

/** What a portrait is of. */
export interface Subject {
  readonly mesh: Pick<Mesh, 'positions' | 'triangles'>;
  /** #P×3, unit: shade it as if these were its normals. Without them every face is flat. */
  readonly normals?: Float64Array;
}

/**
 * Small pictures in the viewer's own light, of anything but the mesh on the stage. One graphics context for all of them: make
 * one, take the pictures, {@link Portraits.dispose | dispose} of it.
 */
export class Portraits {
  readonly #renderer: WebGLRenderer;
  readonly #scene = new Scene();
  readonly #stage = new Stage(this.#scene);
  readonly #camera = new PerspectiveCamera(28, 1, 0.1, 20);
  readonly #material = new MeshStandardMaterial({ roughness: 0.62, side: DoubleSide });

  /** @throws Error when the browser gives no WebGL context */
  constructor(size: number, theme: StageTheme) {
    const canvas = document.createElement('canvas');
    this.#renderer = new WebGLRenderer({ canvas, antialias: true, alpha: true });
    this.#renderer.setSize(size, size, false);
    this.#stage.apply(theme);
    this.#stage.placeFloor(-100);
    this.#material.color.set(theme.clay);
    this.#camera.position.set(0.52, 0.42, 1).setLength(4.3);
    this.#camera.lookAt(0, 0, 0);
  }

  /** Draws into a canvas of the page, over what is there. */
  draw({ mesh, normals }: Subject, into: HTMLCanvasElement): void {
    const surface = new Surface(mesh as Mesh);
    if (normals) shadeBy(normals, surface.geometry);
    if (this.#material.flatShading === (normals !== undefined)) {
      this.#material.flatShading = normals === undefined;
      this.#material.needsUpdate = true;
    }
    const body = new MeshObject(surface.geometry, this.#material);
    body.scale.setScalar(1 / (surface.reach || 1));
    this.#scene.add(body);
    this.#renderer.render(this.#scene, this.#camera);
    this.#scene.remove(body);
    surface.dispose();
    const pen = into.getContext('2d');
    pen?.clearRect(0, 0, into.width, into.height);
    pen?.drawImage(this.#renderer.domElement, 0, 0, into.width, into.height);
  }

  dispose(): void {
    this.#stage.dispose();
    this.#material.dispose();
    this.#renderer.dispose();
    this.#renderer.forceContextLoss();
  }
}

function shadeBy(normals: Float64Array, geometry: BufferGeometry): void {
  geometry.setAttribute('normal', new BufferAttribute(Float32Array.from(normals), 3));
}
