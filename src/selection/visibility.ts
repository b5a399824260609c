import { faceCount, faceOfSide, type Topology } from './topology.ts';
import { pieceLength, type Work } from './work.ts';

/** A shape as a camera sees it. */
export interface ScreenShape {
  /** #V×2 CSS pixels from the canvas's top left; NaN for what is behind the camera. */
  readonly places: Float32Array;
  /** #V, how far from the camera, along its axis, in any unit. */
  readonly depths: Float32Array;
  /** So many pixels is a thing high that is one unit high and one unit away. */
  readonly focal: number;
  readonly width: number;
  readonly height: number;
}

export type Facing = 'out' | 'in' | 'neither';

/** A vertex is surely seen if it lies less than so many pixels behind what is seen at its pixel, and surely hidden beyond the other. */
const surely = 1;
const hardly = 6;

/**
 * What of a shape is hidden behind itself: the depth of all faces at every pixel, drawn once for a view, so that asking for a hundred
 * thousand vertices costs next to nothing. Where depth alone does not tell (a steep slope, or a sheet and its other side), a vertex
 * is seen if one of its faces looks at the camera.
 */
export class Visibility {
  readonly #topology: Topology;
  readonly #screen: ScreenShape;
  readonly #isOutside: boolean | null;
  /** Reciprocal depth of the nearest face at each pixel, 0 where there is none: it is linear over a face on the screen. */
  readonly #nearest: Float32Array;

  private constructor(
    topology: Topology,
    screen: ScreenShape,
    { isOutside, nearest }: { isOutside: boolean | null; nearest: Float32Array },
  ) {
    this.#topology = topology;
    this.#screen = screen;
    this.#isOutside = isOutside;
    this.#nearest = nearest;
  }

  /** @param facing where the faces look, of a closed shape; `neither` of a sheet, which has no far side */
  static *of(topology: Topology, screen: ScreenShape, facing: Facing): Work<Visibility> {
    const nearest = yield* nearestFaces(topology, screen);
    const isOutside = facing === 'neither' ? null : facing === 'out';
    return new Visibility(topology, screen, { isOutside, nearest });
  }

  sees(vertex: number): boolean {
    const { places, depths, focal, width, height } = this.#screen;
    const x = Math.floor(places[2 * vertex]!);
    const y = Math.floor(places[2 * vertex + 1]!);
    if (!(x >= 0 && x < width && y >= 0 && y < height)) return false;
    const nearest = this.#nearest[y * Math.ceil(width) + x]!;
    // A pixel at the horizon, whose middle no face covers.
    if (nearest === 0) return this.#looksHere(vertex);
    const depth = depths[vertex]!;
    const behind = (focal * (depth - 1 / nearest)) / depth;
    if (behind < surely) return true;
    return behind < hardly && this.#looksHere(vertex);
  }

  #looksHere(vertex: number): boolean {
    if (this.#isOutside === null) return true;
    const { aroundStart, edgesAround, sideStart, sides } = this.#topology;
    for (let i = aroundStart[vertex]!; i < aroundStart[vertex + 1]!; i++) {
      const edge = edgesAround[i]!;
      for (let k = sideStart[edge]!; k < sideStart[edge + 1]!; k++)
        if (isSeenFromFront(this.#topology, this.#screen, faceOfSide(sides[k]!)) === this.#isOutside)
          return true;
    }
    return false;
  }
}

/** Whether a face's corners go around counter-clockwise on the screen, whose y points down. */
function isSeenFromFront({ triangles }: Topology, { places }: ScreenShape, face: number): boolean {
  const a = 2 * triangles[3 * face]!;
  const b = 2 * triangles[3 * face + 1]!;
  const c = 2 * triangles[3 * face + 2]!;
  const ux = places[b]! - places[a]!;
  const uy = places[b + 1]! - places[a + 1]!;
  const vx = places[c]! - places[a]!;
  const vy = places[c + 1]! - places[a + 1]!;
  return ux * vy - uy * vx < 0;
}

function* nearestFaces(topology: Topology, screen: ScreenShape): Work<Float32Array> {
  const nearest = new Float32Array(Math.ceil(screen.width) * Math.ceil(screen.height));
  const faces = faceCount(topology);
  for (let face = 0; face < faces; face++) {
    drawFace(topology.triangles, screen, nearest, face);
    if (face % (pieceLength / 4) === 0) yield;
  }
  return nearest;
}

/** Draws a face at the pixels whose middles it covers. Corners without a place (NaN) draw nothing. */
function drawFace(triangles: Uint32Array, screen: ScreenShape, nearest: Float32Array, face: number): void {
  const { places, depths } = screen;
  const width = Math.ceil(screen.width);
  const a = triangles[3 * face]!;
  const b = triangles[3 * face + 1]!;
  const c = triangles[3 * face + 2]!;
  const ax = places[2 * a]! - 0.5;
  const ay = places[2 * a + 1]! - 0.5;
  const bx = places[2 * b]! - 0.5;
  const by = places[2 * b + 1]! - 0.5;
  const cx = places[2 * c]! - 0.5;
  const cy = places[2 * c + 1]! - 0.5;
  const left = Math.max(0, Math.ceil(Math.min(ax, bx, cx)));
  const right = Math.min(width - 1, Math.floor(Math.max(ax, bx, cx)));
  const top = Math.max(0, Math.ceil(Math.min(ay, by, cy)));
  const bottom = Math.min(Math.ceil(screen.height) - 1, Math.floor(Math.max(ay, by, cy)));
  const area = (bx - ax) * (cy - ay) - (by - ay) * (cx - ax);
  if (!(left <= right && top <= bottom) || area === 0) return;
  const qa = 1 / depths[a]!;
  const qb = 1 / depths[b]!;
  const qc = 1 / depths[c]!;
  for (let y = top; y <= bottom; y++) {
    for (let x = left; x <= right; x++) {
      const u = ((cx - bx) * (y - by) - (cy - by) * (x - bx)) / area;
      const v = ((ax - cx) * (y - cy) - (ay - cy) * (x - cx)) / area;
      if (u < 0 || v < 0 || u + v > 1) continue;
      const q = u * qa + v * qb + (1 - u - v) * qc;
      if (q > nearest[y * width + x]!) nearest[y * width + x] = q;
    }
  }
}
