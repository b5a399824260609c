import { Group, PCFShadowMap, type PerspectiveCamera, Quaternion, Scene } from 'three';
import type { OrbitControls } from 'three/examples/jsm/controls/OrbitControls.js';
import type { Mesh } from '../mesh/mesh.ts';
import { Body, type Shading } from './body.ts';
import { listenForCameraKeys } from './camera-keys.ts';
import { CameraRig, type Insets } from './camera-rig.ts';
import { Finish } from './finish.ts';
import { Morph } from './morph.ts';
import { RenderLoop } from './render-loop.ts';
import { type Renderer, webGlRenderer } from './renderer.ts';
import { Screen } from './screen.ts';
import { lightTheme, Stage, type StageTheme } from './stage.ts';
import type { Surface } from './surface.ts';
import { toView } from './view-frame.ts';

export type { Shading } from './body.ts';
export type { Insets } from './camera-rig.ts';
export type { Renderer } from './renderer.ts';
export { darkTheme, lightTheme, type StageTheme } from './stage.ts';

export interface ViewerOptions {
  readonly createRenderer?: (canvas: HTMLCanvasElement) => Renderer;
  /** Most device pixels per CSS pixel; default 2. */
  readonly maxPixelRatio?: number;
  /** The graphics context is gone (true) or back (false). The viewer draws again by itself when it is back. */
  readonly onContext?: (lost: boolean) => void;
}

/** Where tools beside the viewer point and draw. */
export interface ViewSpace {
  readonly camera: PerspectiveCamera;
  readonly controls: OrbitControls;
  /** Has the file's axes, in view units. What is in it and in {@link gizmos} is in no picture that is saved. */
  readonly overlay: Group;
  /** Has the world's axes, of which y points up. */
  readonly gizmos: Group;
  /** Null while nothing is shown. */
  readonly surface: Surface | null;
}

/** What became of the shape on the screen: it is another mesh, or has other positions. */
export type ShapeChange = 'mesh' | 'positions';

/** All that one picture is drawn from, for who draws several. */
export interface Studio {
  readonly renderer: Renderer;
  readonly scene: Scene;
  readonly camera: PerspectiveCamera;
  readonly stage: Stage;
  /** Has the file's axes, in view units. */
  readonly turned: Group;
  /** What is shown; null while nothing is. */
  readonly body: Body | null;
  readonly theme: StageTheme;
  readonly shading: Shading;
  /** Whether the file's z axis points up. */
  readonly zUp: boolean;
}

/** Draws one mesh on a canvas. Draws on demand only; every setter asks for a drawing. */
export class Viewer {
  readonly canvas: HTMLCanvasElement;
  readonly #renderer: Renderer;
  readonly #scene = new Scene();
  readonly #turned = new Group();
  readonly #overlay = new Group();
  readonly #gizmos = new Group();
  readonly #stage = new Stage(this.#scene);
  readonly #rig: CameraRig;
  readonly #loop = new RenderLoop((now) => this.#draw(now));
  readonly #finish = new Finish();
  readonly #maxPixelRatio: number;
  readonly #off = new AbortController();
  readonly #screen: Screen;
  #body: Body | null = null;
  #drawPictures: ((studio: Studio) => void) | null = null;
  #shading: Shading = 'smooth';
  #theme = lightTheme;
  #morph: Morph | null = null;
  #zUp = false;
  #drawings = 0;
  readonly #turnListeners = new Set<() => void>();
  readonly #shapeListeners = new Set<(change: ShapeChange) => void>();
  readonly #seenFrom = new Quaternion();

  /** @throws Error with a sentence for people when the browser gives no WebGL context */
  constructor(canvas: HTMLCanvasElement, options: ViewerOptions = {}) {
    this.canvas = canvas;
    this.#maxPixelRatio = options.maxPixelRatio ?? 2;
    this.#renderer = (options.createRenderer ?? webGlRenderer)(canvas);
    this.#screen = new Screen(this.#renderer);
    this.#renderer.shadowMap.enabled = true;
    this.#renderer.shadowMap.type = PCFShadowMap;
    this.#renderer.shadowMap.autoUpdate = false;
    this.#rig = new CameraRig(canvas, this.#loop.invalidate);
    listenForCameraKeys(canvas, this.#rig, this.#loop.invalidate, this.#off.signal);
    this.#scene.add(this.#turned, this.#gizmos);
    this.#turned.add(this.#overlay);
    this.#watchContext(options.onContext ?? (() => {}));
    this.setTheme(lightTheme);
  }

  /** How often it has drawn; a page at rest does not count up. */
  get drawings(): number {
    return this.#drawings;
  }

  /** From where one looks, and whether the file's z axis points up there. */
  get view(): { readonly orientation: Quaternion; readonly zUp: boolean } {
    return { orientation: this.#rig.camera.quaternion, zUp: this.#zUp };
  }

  /** Calls the listener whenever {@link view} has changed, until the returned function is called. */
  onTurn(listener: () => void): () => void {
    this.#turnListeners.add(listener);
    return () => this.#turnListeners.delete(listener);
  }

  /** What tools beside the viewer build on: where they point from, where they draw, what is drawn now. */
  get space(): ViewSpace {
    const { camera, controls } = this.#rig;
    return { camera, controls, overlay: this.#overlay, gizmos: this.#gizmos, surface: this.#surface };
  }

  /** Tells of another mesh, and of other positions of it, until the returned function is called. */
  onShape(listener: (change: ShapeChange) => void): () => void {
    this.#shapeListeners.add(listener);
    return () => this.#shapeListeners.delete(listener);
  }

  /** Whether the view stays where it is though the shape outgrows it: for tools, under which it must not move. Default false. */
  holdView(isHeld: boolean): void {
    this.#rig.isHeld = isHeld;
  }

  /** Asks for one drawing. */
  readonly invalidate = (): void => this.#loop.invalidate();

  /** Shows another mesh and frames it. @param up the axis that points up in the file */
  show(mesh: Mesh, up: 'y' | 'z' = 'y'): void {
    this.clear();
    this.#body = new Body(mesh, this.#finish);
    this.#turned.add(this.#body.object);
    this.#zUp = up === 'z';
    this.#turned.rotation.x = this.#zUp ? -Math.PI / 2 : 0;
    this.#paint();
    this.setShading(this.#shading);
    this.#measure();
    this.#rig.fit(this.#reach, false);
    this.#changed('mesh');
  }

  clear(): void {
    this.#morph = null;
    this.#body?.dispose();
    this.#body = null;
    this.#loop.invalidate();
  }

  /** Draws other positions (#P×3, the file's units) of the mesh that is shown. @param glide milliseconds to get there */
  update(positions: Float64Array, glide = 0): void {
    if (!this.#surface) return;
    this.#morph = null;
    if (glide > 0) {
      const target = new Float32Array(this.#surface.drawn.length);
      toView(positions, this.#surface.frame, target);
      this.#morph = new Morph(this.#surface.drawn, target, performance.now(), glide);
    } else {
      this.#surface.write(positions);
    }
    this.#changed('positions');
  }

  setShading(shading: Shading): void {
    this.#shading = shading;
    this.#body?.shade(shading);
    this.#loop.invalidate();
  }

  /** Colours the mesh by something other than its file, #P×3 linear; null takes that away. The next {@link show} does too. */
  setColors(colors: Float32Array<ArrayBuffer> | null): void {
    this.#surface?.paint(colors);
    this.#paint();
    this.#loop.invalidate();
  }

  /** Draws colours that were written into the array last given to {@link setColors}. @param touched its positions */
  touchColors(touched: ArrayLike<number>): void {
    this.#surface?.touchColors(touched);
    this.#loop.invalidate();
  }

  setTheme(theme: StageTheme): void {
    this.#theme = theme;
    this.#stage.apply(theme);
    this.#paint();
    this.#loop.invalidate();
  }

  /** Has several pictures drawn in place of the one; null for the one. */
  drawPictures(draw: ((studio: Studio) => void) | null): void {
    this.#drawPictures = draw;
    this.#renderer.shadowMap.needsUpdate = true;
    if (!draw && this.#surface) this.#placeFloor(this.#surface);
    this.#loop.invalidate();
  }

  resize(width: number, height: number, pixelRatio: number): void {
    this.#screen.resize(width, height, Math.min(pixelRatio, this.#maxPixelRatio));
    this.#rig.resize(width, height);
    this.#loop.invalidate();
  }

  setInsets(insets: Insets): void {
    this.#rig.setInsets(insets);
    this.#loop.invalidate();
  }

  fit(glide = true): void {
    this.#rig.fit(this.#reach, glide);
    this.#loop.invalidate();
  }

  /** Frames the mesh anew where some of it has come under what covers the canvas, unless a hand has moved the camera. */
  uncover(): void {
    if (!this.#surface) return;
    this.#turned.updateMatrixWorld();
    this.#rig.uncover(this.#surface.samples(this.#turned.matrixWorld), this.#reach);
    this.#loop.invalidate();
  }

  /** What the canvas shows, on a colour of your choice (default: see-through). */
  snapshot(background?: string): Promise<Blob> {
    this.#screen.sharpen();
    this.#overlay.visible = this.#gizmos.visible = false;
    this.#render();
    this.#overlay.visible = this.#gizmos.visible = true;
    this.#loop.invalidate();
    const copy = document.createElement('canvas');
    copy.width = this.canvas.width;
    copy.height = this.canvas.height;
    const pen = copy.getContext('2d');
    if (pen && background) {
      pen.fillStyle = background;
      pen.fillRect(0, 0, copy.width, copy.height);
    }
    pen?.drawImage(this.canvas, 0, 0);
    return new Promise((resolve, reject) =>
      copy.toBlob((blob) => (blob ? resolve(blob) : reject(new Error('The picture could not be made.')))),
    );
  }

  dispose(): void {
    this.#loop.pause();
    this.#screen.dispose();
    this.#off.abort();
    this.clear();
    this.#rig.dispose();
    this.#stage.dispose();
    this.#finish.dispose();
    this.#renderer.dispose();
  }

  /** The ball to frame: what is drawn and some air, but never less than the file's own box, so that the camera mostly rests. */
  get #reach(): number {
    return Math.max(1, this.#surface ? 1.08 * this.#surface.reach : 1);
  }

  get #surface(): Surface | null {
    return this.#body?.surface ?? null;
  }

  #paint(): void {
    this.#finish.paint(this.#theme, this.#surface?.hasColors ?? false);
  }

  #measure(): void {
    const [x, y, z] = this.#surface!.size;
    this.#stage.setFootprint([x, this.#zUp ? y : z]);
  }

  #placeFloor(surface: Surface): void {
    this.#stage.placeFloor(surface.lowest(this.#zUp ? 2 : 1));
  }

  #changed(change: ShapeChange): void {
    for (const listener of this.#shapeListeners) listener(change);
    if (this.#surface) this.#placeFloor(this.#surface);
    this.#rig.follow(this.#reach);
    this.#renderer.shadowMap.needsUpdate = true;
    this.#loop.invalidate();
  }

  #draw(now: number): void {
    this.#screen.move(now, () => this.#render());
    if (this.#morph && this.#surface) {
      if (!this.#morph.write(now, this.#surface.drawn)) this.#morph = null;
      this.#surface.touch();
      this.#changed('positions');
    }
    if (this.#rig.update(now)) this.#loop.invalidate();
    this.#render();
    this.#tellTurn();
  }

  #tellTurn(): void {
    const { quaternion } = this.#rig.camera;
    if (this.#seenFrom.equals(quaternion)) return;
    this.#seenFrom.copy(quaternion);
    for (const listener of this.#turnListeners) listener();
  }

  #render(): void {
    this.#drawings++;
    if (this.#drawPictures) this.#drawPictures(this.#studio);
    else this.#renderer.render(this.#scene, this.#rig.camera);
  }

  get #studio(): Studio {
    return {
      renderer: this.#renderer,
      scene: this.#scene,
      camera: this.#rig.camera,
      stage: this.#stage,
      turned: this.#turned,
      body: this.#body,
      theme: this.#theme,
      shading: this.#shading,
      zUp: this.#zUp,
    };
  }

  #watchContext(tell: (lost: boolean) => void): void {
    const { signal } = this.#off;
    this.canvas.addEventListener(
      'webglcontextlost',
      (event) => {
        event.preventDefault();
        this.#loop.pause();
        tell(true);
      },
      { signal },
    );
    this.canvas.addEventListener(
      'webglcontextrestored',
      () => {
        this.#renderer.shadowMap.needsUpdate = true;
        this.#loop.resume();
        tell(false);
      },
      { signal },
    );
  }
}
