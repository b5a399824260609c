import {
  BufferAttribute,
  BufferGeometry,
  Color,
  DynamicDrawUsage,
  Group,
  LineBasicMaterial,
  LineLoop,
  Mesh as MeshObject,
  MeshStandardMaterial,
  OrthographicCamera,
  Quaternion,
  Scene,
  Vector3,
  WebGLRenderer,
} from 'three';
import { Stage, type StageTheme } from './stage.ts';

type Triple = readonly [number, number, number];

/** So far the camera sees around the unit ball. */
const reach = 1.06;
const ringPoints = 48;

/**
 * A unit ball that is lit as if it had other normals and coloured by them: what a style asks of a sphere. It is seen from where
 * one looks at the mesh; its own axes are the file's.
 */
export class PaintBall {
  readonly #renderer: WebGLRenderer;
  readonly #scene = new Scene();
  readonly #stage = new Stage(this.#scene);
  readonly #camera = new OrthographicCamera(-reach, reach, reach, -reach, 0.1, 10);
  readonly #turned = new Group();
  readonly #geometry = new BufferGeometry();
  readonly #material = new MeshStandardMaterial({ roughness: 0.7, vertexColors: true });
  readonly #ring: LineLoop<BufferGeometry, LineBasicMaterial>;
  #clay = new Color();

  /** @throws Error when the browser gives no WebGL context */
  constructor(canvas: HTMLCanvasElement, points: Float64Array, triangles: Uint32Array) {
    this.#renderer = new WebGLRenderer({ canvas, antialias: true, alpha: true });
    this.#renderer.setPixelRatio(Math.min(2, devicePixelRatio));
    this.#renderer.setSize(canvas.clientWidth || 200, canvas.clientHeight || 200, false);
    const dynamic = () => new BufferAttribute(new Float32Array(points.length), 3).setUsage(DynamicDrawUsage);
    this.#geometry.setAttribute('position', new BufferAttribute(Float32Array.from(points), 3));
    this.#geometry.setAttribute('normal', dynamic());
    this.#geometry.setAttribute('color', dynamic());
    this.#geometry.setIndex(new BufferAttribute(triangles, 1));
    const ring = new BufferGeometry().setAttribute(
      'position',
      new BufferAttribute(new Float32Array(3 * ringPoints), 3).setUsage(DynamicDrawUsage),
    );
    this.#ring = new LineLoop(ring, new LineBasicMaterial({ depthTest: false, transparent: true }));
    this.#ring.visible = false;
    this.#ring.frustumCulled = false;
    this.#turned.add(new MeshObject(this.#geometry, this.#material), this.#ring);
    this.#scene.add(this.#turned);
    this.#stage.placeFloor(-100);
  }

  setTheme(theme: StageTheme): void {
    this.#stage.apply(theme);
    this.#clay = new Color(theme.clay);
    this.#ring.material.color.set(theme.wire);
  }

  /** @param orientation the main camera's   @param zUp the file's z axis points up */
  setView(orientation: Quaternion, zUp: boolean): void {
    this.#camera.quaternion.copy(orientation);
    this.#camera.position.set(0, 0, 4).applyQuaternion(orientation);
    this.#turned.rotation.x = zUp ? -Math.PI / 2 : 0;
    this.#scene.updateMatrixWorld();
  }

  /** @param normals unit, one per point of the ball */
  setNormals(normals: Float64Array): void {
    const shaded = this.#geometry.getAttribute('normal') as BufferAttribute;
    const colors = this.#geometry.getAttribute('color') as BufferAttribute;
    shaded.array.set(normals);
    for (let v = 0; 3 * v < normals.length; v++) {
      const color = normalColor([normals[3 * v]!, normals[3 * v + 1]!, normals[3 * v + 2]!]);
      colors.setXYZ(v, ...(color.lerp(this.#clay, 0.25).toArray() as [number, number, number]));
    }
    shaded.needsUpdate = colors.needsUpdate = true;
  }

  /** Colours the ball and leaves it round. @param colors linear, three numbers a point */
  setColors(colors: Float32Array): void {
    const shaded = this.#geometry.getAttribute('normal') as BufferAttribute;
    const shown = this.#geometry.getAttribute('color') as BufferAttribute;
    shaded.array.set(this.#geometry.getAttribute('position').array);
    shown.array.set(colors);
    shaded.needsUpdate = shown.needsUpdate = true;
  }

  /** Shows where the brush would touch. @param radius in degrees; null takes the ring away */
  setCursor(point: Triple | null, radius = 0): void {
    this.#ring.visible = point !== null;
    if (!point) return;
    const axis = new Vector3(...point);
    const turn = new Quaternion().setFromUnitVectors(new Vector3(0, 0, 1), axis);
    const angle = (radius * Math.PI) / 180;
    const place = this.#ring.geometry.getAttribute('position') as BufferAttribute;
    for (let k = 0; k < ringPoints; k++) {
      const around = (2 * Math.PI * k) / ringPoints;
      const at = new Vector3(
        Math.sin(angle) * Math.cos(around),
        Math.sin(angle) * Math.sin(around),
        Math.cos(angle),
      );
      at.applyQuaternion(turn).multiplyScalar(1.01);
      place.setXYZ(k, at.x, at.y, at.z);
    }
    place.needsUpdate = true;
  }

  /** The point of the ball under a place of the canvas, both from −1 to 1 with y up; null beside it. */
  pick(x: number, y: number): [number, number, number] | null {
    const square = (x * x + y * y) * reach * reach;
    if (square > 1) return null;
    const seen = new Vector3(x * reach, y * reach, Math.sqrt(1 - square));
    return this.#toFile(seen);
  }

  draw(): void {
    this.#renderer.render(this.#scene, this.#camera);
  }

  dispose(): void {
    this.#stage.dispose();
    this.#geometry.dispose();
    this.#material.dispose();
    this.#ring.geometry.dispose();
    this.#ring.material.dispose();
    this.#renderer.dispose();
    this.#renderer.forceContextLoss();
  }

  #toFile(seen: Vector3): [number, number, number] {
    seen.applyQuaternion(this.#camera.quaternion).applyQuaternion(this.#turned.quaternion.clone().invert());
    return seen.toArray();
  }
}

/** The colour that a normal capture gives a normal. */
export function normalColor(normal: Triple): Color {
  return new Color().setRGB((normal[0] + 1) / 2, (normal[1] + 1) / 2, (normal[2] + 1) / 2, 'srgb');
}
