import {
  CanvasTexture,
  Color,
  DirectionalLight,
  Group,
  HemisphereLight,
  Mesh,
  MeshBasicMaterial,
  PlaneGeometry,
  type Scene,
  ShadowMaterial,
} from 'three';

/** Colours and strengths that belong to a page's theme. Colours are CSS hexadecimal strings. */
export interface StageTheme {
  /** The clay, where the file has no colours of its own. */
  readonly clay: string;
  readonly wire: string;
  readonly wireOpacity: number;
  readonly sky: string;
  readonly ground: string;
  readonly ambient: number;
  readonly key: number;
  readonly fill: number;
  readonly rim: number;
  readonly shadow: number;
  readonly shadowColor: string;
}

export const lightTheme: StageTheme = Object.freeze({
  clay: '#e2936a',
  wire: '#4a2312',
  wireOpacity: 0.34,
  sky: '#fff6ea',
  ground: '#c99a7c',
  ambient: 1.35,
  key: 2.5,
  fill: 0.5,
  rim: 0.9,
  shadow: 0.2,
  shadowColor: '#2a1408',
});

export const darkTheme: StageTheme = Object.freeze({
  clay: '#e08a5e',
  wire: '#ffe3d0',
  wireOpacity: 0.26,
  sky: '#bfc8d8',
  ground: '#5a3a2a',
  ambient: 0.75,
  key: 2.3,
  fill: 0.35,
  rim: 1.7,
  shadow: 0.5,
  shadowColor: '#000000',
});

/** A small photo studio: soft sky, a key light that casts a shadow, a cool fill, a rim from behind, a floor for the shadow. */
export class Stage {
  readonly group = new Group();
  readonly #sky = new HemisphereLight();
  readonly #key = new DirectionalLight();
  readonly #fill = new DirectionalLight('#dfe9ff');
  readonly #rim = new DirectionalLight('#fff1e0');
  readonly #floor = new Mesh(new PlaneGeometry(14, 14), new ShadowMaterial({ depthWrite: false }));
  readonly #contact = new Mesh(
    new PlaneGeometry(1, 1),
    new MeshBasicMaterial({ transparent: true, depthWrite: false, toneMapped: false }),
  );

  constructor(scene: Scene) {
    this.#key.position.set(-1.3, 3.6, 1.9);
    this.#fill.position.set(3, 0.8, 1.6);
    this.#rim.position.set(0.8, 1.6, -3);
    this.#setUpShadow();
    this.#floor.rotation.x = -Math.PI / 2;
    this.#floor.receiveShadow = true;
    this.#contact.rotation.x = -Math.PI / 2;
    this.#contact.renderOrder = -1;
    this.#contact.material.alphaMap = softDisc();
    this.group.add(this.#sky, this.#key, this.#fill, this.#rim, this.#floor, this.#contact);
    scene.add(this.group);
  }

  apply(theme: StageTheme): void {
    this.#sky.color = new Color(theme.sky);
    this.#sky.groundColor = new Color(theme.ground);
    this.#sky.intensity = theme.ambient;
    this.#key.intensity = theme.key;
    this.#fill.intensity = theme.fill;
    this.#rim.intensity = theme.rim;
    this.#floor.material.color.set(theme.shadowColor);
    this.#floor.material.opacity = theme.shadow;
    this.#contact.material.color.set(theme.shadowColor);
    this.#contact.material.opacity = theme.shadow * 1.1;
  }

  /** How far the shade under the object reaches. @param footprint the object's width and depth */
  setFootprint(footprint: readonly [number, number]): void {
    this.#contact.scale.set(footprint[0] * 1.5, footprint[1] * 1.5, 1);
  }

  /** Puts the floor at a height. */
  placeFloor(height: number): void {
    this.#floor.position.y = height - 0.004;
    this.#contact.position.y = height - 0.002;
  }

  dispose(): void {
    this.#floor.geometry.dispose();
    this.#floor.material.dispose();
    this.#contact.geometry.dispose();
    this.#contact.material.alphaMap?.dispose();
    this.#contact.material.dispose();
    this.#key.shadow.dispose();
  }

  #setUpShadow(): void {
    this.#key.castShadow = true;
    const { shadow } = this.#key;
    shadow.mapSize.set(1024, 1024);
    shadow.radius = 4.5;
    shadow.bias = -0.0004;
    shadow.normalBias = 0.01;
    const { camera } = shadow;
    camera.left = camera.bottom = -1.7;
    camera.right = camera.top = 1.7;
    camera.near = 0.5;
    camera.far = 9;
  }
}

/** A radial fall-off, dark in the middle: the shade an object standing on a floor has under it. Null without a document. */
function softDisc(): CanvasTexture | null {
  if (typeof document === 'undefined') return null;
  const canvas = document.createElement('canvas');
  canvas.width = canvas.height = 128;
  const pen = canvas.getContext('2d');
  if (!pen) return null;
  const gradient = pen.createRadialGradient(64, 64, 0, 64, 64, 64);
  gradient.addColorStop(0, '#fff');
  gradient.addColorStop(0.35, '#999');
  gradient.addColorStop(0.7, '#262626');
  gradient.addColorStop(1, '#000');
  pen.fillStyle = gradient;
  pen.fillRect(0, 0, 128, 128);
  return new CanvasTexture(canvas);
}
