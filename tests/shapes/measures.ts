import { add, cross, distance, row, scale, subtract, unit, type Vec3 } from '../../src/mesh/vectors.ts';
import type { Handles } from '../../src/methods/values/handles.ts';
import { extent, fittedRound, principalAxes } from './fits.ts';
import { coordinates, frameOf } from './frames.ts';
import type { Shape } from './shape.ts';
import { part } from './shape.ts';
import { degreesBetween, normalsOf, qualityOf, SurfaceFacts } from './surface-facts.ts';
import { changeOfThickness, quantile, type Wall, wallsOf } from './walls.ts';

/** What becomes of the size of a part that is to keep it: 1 is as it was. */
export interface Kept {
  readonly name: string;
  readonly ratio: number;
  /** Of round parts: by how much they are off the ball or cylinder, as a share of its radius. */
  readonly roundness?: number;
}

/** What a person would see of a reshaped shape. Lengths are shares of the diagonal of the box around the shape before, angles degrees. */
export interface Measures {
  /** The farthest that a handle is from where it was to go. */
  readonly handle: number;
  /** By how much faces look another way than before. */
  readonly normalMean: number;
  readonly normalMax: number;
  /** How many faces look the opposite way, slivers left out. */
  readonly flipped: number;
  /** The largest turn of a flat part of eight faces and more. */
  readonly planeTilt: number;
  /** The farthest that a vertex of a straight crease is off its line. */
  readonly lineBend: number;
  readonly rounds: readonly Kept[];
  readonly bevels: readonly Kept[];
  /** The quality of faces, 4√3·area/Σ sides², as a ratio of after and before: that which 1 % of the faces stay below. */
  readonly quality: number;
  /** The mean over smooth edges of how differently the faces on either side stretch, across the edge. */
  readonly stretchJump: number;
  /** The largest change, but for 5 % of the places, of the distance between faces that back each other, as a share of it. */
  readonly thickness: number;
}

/** Measures of shapes of which the facts before are gathered once. */
export class Judge {
  readonly #shape: Shape;
  readonly #facts: SurfaceFacts;
  readonly #planes: readonly (readonly number[])[];
  readonly #lines: readonly (readonly number[])[];
  readonly #walls: readonly Wall[];

  constructor(shape: Shape) {
    this.#shape = shape;
    this.#facts = new SurfaceFacts(shape);
    this.#planes = this.#facts.planes();
    this.#lines = this.#facts.straightLines();
    this.#walls = wallsOf(this.#facts);
  }

  measure(positions: Float64Array<ArrayBuffer>, handles: Handles): Measures {
    const before = this.#shape.positions;
    const { diagonal, normals, sound } = this.#facts;
    const after = { positions, triangles: this.#shape.triangles };
    const now = normalsOf(after);
    const turns = now
      .map((normal, face) => degreesBetween(normal, normals[face]!))
      .filter((_, face) => sound[face]);
    const misses = handles.vertices.map(
      (v, k) => distance(row(positions, v), handles.targets[k]!) / diagonal,
    );
    const tilts = this.#planes.map((plane) => tiltOf(before, positions, plane));
    const bends = this.#lines.map((line) => bendOf(positions, line) / diagonal);
    const ratios = normals.flatMap((_, face) =>
      sound[face] ? [qualityOf(after, face) / qualityOf(this.#shape, face)] : [],
    );
    return {
      handle: Math.max(0, ...misses),
      normalMean: mean(turns),
      normalMax: turns.reduce((a, b) => Math.max(a, b), 0),
      flipped: turns.filter((angle) => angle > 90).length,
      planeTilt: Math.max(0, ...tilts),
      lineBend: Math.max(0, ...bends),
      rounds: this.#shape.rounds.map(({ name, vertices, axis }) => {
        const [was, is] = [before, positions].map((at) => fittedRound(at, vertices, axis));
        return { name, ratio: is!.radius / was!.radius, roundness: is!.roundness };
      }),
      bevels: this.#shape.bevels.map((name) => {
        const [was, is] = [before, positions].map((at) => widthOf(at, part(this.#shape, name)));
        return { name, ratio: is! / was! };
      }),
      quality: quantile(ratios, 0.01),
      stretchJump: this.#stretchJump(positions, now),
      thickness: changeOfThickness(this.#walls, after, now),
    };
  }

  #stretchJump(positions: Float64Array<ArrayBuffer>, now: readonly Vec3[]): number {
    const { mesh, normals, pairs, sound } = this.#facts;
    const after = { positions, triangles: mesh.triangles };
    const smooth = pairs.filter(({ angle, faces }) => angle < 40 && sound[faces[0]] && sound[faces[1]]);
    return mean(
      smooth.map(({ faces, opposite }) => {
        const across = unit(subtract(row(mesh.positions, opposite[0]), row(mesh.positions, opposite[1])));
        const [a, b] = faces.map((face) => {
          const before = frameOf(mesh, face, normals[face]!);
          const frame = frameOf(after, face, now[face]!);
          const weights = coordinates(before, across);
          return frame.reduce((sum, axis, k) => add(sum, scale(axis, weights[k]!)), [0, 0, 0] as Vec3);
        });
        return distance(a!, b!);
      }),
    );
  }
}

function tiltOf(before: Float64Array, after: Float64Array, plane: readonly number[]): number {
  const [was, is] = [before, after].map((at) => principalAxes(at, plane).axes[0]);
  const angle = degreesBetween(was!, is!);
  return Math.min(angle, 180 - angle);
}

function bendOf(positions: Float64Array, line: readonly number[]): number {
  const { middle, axes } = principalAxes(positions, line);
  return Math.max(...line.map((v) => Math.hypot(...cross(subtract(row(positions, v), middle), axes[2]))));
}

/** The narrower way across a flat strip. */
function widthOf(positions: Float64Array, strip: readonly number[]): number {
  return extent(positions, strip, principalAxes(positions, strip).axes[1]);
}

const mean = (values: readonly number[]): number =>
  values.reduce((a, b) => a + b, 0) / Math.max(1, values.length);
