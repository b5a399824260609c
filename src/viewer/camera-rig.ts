import { PerspectiveCamera, Spherical, Vector3 } from 'three';
import { OrbitControls } from 'three/examples/jsm/controls/OrbitControls.js';

/** Parts of the canvas that other things cover, in CSS pixels. The object is centred in what is left. */
export interface Insets {
  readonly top: number;
  readonly right: number;
  readonly bottom: number;
  readonly left: number;
}

const home = new Vector3(0.52, 0.34, 1).normalize();
const fieldOfView = 28;

/** The camera, its orbit, and where it should be: a fit is a goal that it glides to, a hand on the controls drops the goal. */
export class CameraRig {
  readonly camera = new PerspectiveCamera(fieldOfView, 1, 0.05, 60);
  readonly controls: OrbitControls;
  #size = { width: 1, height: 1 };
  #insets: Insets = { top: 0, right: 0, bottom: 0, left: 0 };
  #glide: { position: Vector3; target: Vector3 } | null = null;
  #radius = 1;
  /** The view stays where it is: what a pointer has hold of must not move away under it. */
  isHeld = false;
  /** A hand has moved the camera since the last fit. */
  #isMoved = false;
  #last = 0;

  constructor(element: HTMLElement, onChange: () => void) {
    this.controls = new OrbitControls(this.camera, element);
    this.controls.enableDamping = true;
    this.controls.dampingFactor = 0.12;
    this.controls.minDistance = 0.4;
    this.controls.maxDistance = 20;
    this.controls.addEventListener('change', onChange);
    this.controls.addEventListener('start', () => {
      this.#glide = null;
      this.#isMoved = true;
    });
    this.fit(1, false);
  }

  /** Frames a sphere about the origin. */
  fit(radius: number, glide: boolean): void {
    this.#radius = radius;
    this.#isMoved = false;
    const free = this.#freeArea();
    const tangent = Math.tan((fieldOfView * Math.PI) / 360);
    // The view's height belongs to the whole canvas; the sphere has to fit the free part of it, both ways.
    const share = Math.min(free.height, free.width) / this.#size.height;
    const distance = (radius * 0.94) / Math.max(0.02, tangent * share);
    const goal = { position: home.clone().multiplyScalar(distance), target: new Vector3() };
    this.controls.maxDistance = Math.max(20, distance * 2);
    if (glide) {
      this.#glide = goal;
      return;
    }
    this.#glide = null;
    this.camera.position.copy(goal.position);
    this.controls.target.copy(goal.target);
    this.controls.update();
  }

  /** Frames what has outgrown the frame, or needs less of it again, unless a hand has moved the camera or works on the mesh. */
  follow(radius: number): void {
    if (!this.isHeld && !this.#isMoved && Math.abs(radius / this.#radius - 1) > 0.03) this.fit(radius, true);
  }

  /** Frames a sphere anew if one of these places (world units) is not seen, unless a hand has moved the camera. */
  uncover(places: Iterable<Vector3>, radius: number): void {
    if (this.#isMoved) return;
    const { top, right, bottom, left } = this.#insets;
    const { width, height } = this.#size;
    this.camera.updateMatrixWorld();
    for (const place of places) {
      const { x, y } = place.project(this.camera);
      const across = ((x + 1) * width) / 2;
      const down = ((1 - y) * height) / 2;
      if (across >= left && across <= width - right && down >= top && down <= height - bottom) continue;
      this.fit(radius, true);
      return;
    }
  }

  /** Goes around the object. @param azimuth to the right, in radians   @param polar upwards */
  turn(azimuth: number, polar: number): void {
    const { target } = this.controls;
    const place = new Spherical().setFromVector3(this.camera.position.clone().sub(target));
    place.theta += azimuth;
    place.phi = Math.min(Math.PI - 0.01, Math.max(0.01, place.phi - polar));
    this.#place(new Vector3().setFromSpherical(place).add(target));
  }

  /** Goes nearer (factor < 1) or away. */
  approach(factor: number): void {
    const { target, minDistance, maxDistance } = this.controls;
    const offset = this.camera.position.clone().sub(target);
    offset.clampLength(minDistance / factor, maxDistance / factor).multiplyScalar(factor);
    this.#place(offset.add(target));
  }

  resize(width: number, height: number): void {
    const before = this.#size;
    this.#size = { width: Math.max(1, width), height: Math.max(1, height) };
    this.#project();
    if (before.width === 1) this.fit(this.#radius, false);
  }

  setInsets(insets: Insets): void {
    this.#insets = insets;
    this.#project();
  }

  /** Moves on by one frame; true while there is more to move. */
  update(now: number): boolean {
    const elapsed = Math.min(0.1, Math.max(0.001, (now - this.#last) / 1000));
    this.#last = now;
    if (this.#glide) {
      const share = 1 - Math.exp(-9 * elapsed);
      this.camera.position.lerp(this.#glide.position, share);
      this.controls.target.lerp(this.#glide.target, share);
      if (this.camera.position.distanceTo(this.#glide.position) < 1e-3) this.#glide = null;
    }
    return this.controls.update(elapsed) || this.#glide !== null;
  }

  dispose(): void {
    this.controls.dispose();
  }

  /** A hand, or a key, puts the camera somewhere. */
  #place(position: Vector3): void {
    this.#glide = null;
    this.#isMoved = true;
    this.camera.position.copy(position);
    this.controls.update();
  }

  #freeArea(): { width: number; height: number } {
    const { top, right, bottom, left } = this.#insets;
    return {
      width: Math.max(80, this.#size.width - left - right),
      height: Math.max(80, this.#size.height - top - bottom),
    };
  }

  #project(): void {
    const { width, height } = this.#size;
    const { top, right, bottom, left } = this.#insets;
    this.camera.aspect = width / height;
    this.camera.setViewOffset(width, height, (right - left) / 2, (bottom - top) / 2, width, height);
    this.camera.updateProjectionMatrix();
  }
}
