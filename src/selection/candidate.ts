import { discAround } from './disc.ts';
import {
  facesInside,
  facesOfPart,
  facesOfPatch,
  outlineOf,
  outlineOfFaces,
  verticesOfFaces,
} from './face-sets.ts';
import { flatSideOf } from './flat-sides.ts';
import { membersOf } from './labels.ts';
import { boundaryLoop, featureLoop } from './loops.ts';
import { type Aim, nearestFeature, nearestVertex } from './near-pointer.ts';
import type { SelectableMesh } from './selectable.ts';

/** What a click would take. */
export interface Candidate {
  readonly kind: 'vertex' | 'rim' | 'line' | 'patch' | 'part' | 'spot';
  /** Welded vertices, each once. */
  readonly vertices: Uint32Array;
  /** #×2 welded vertices: the lines to draw. */
  readonly edges: Uint32Array;
  /** Faces to tint, of those that the solver takes; none for lines and vertices. */
  readonly faces: Uint32Array;
  /** In words, such as "a smooth patch of 412 vertices". */
  readonly sentence: string;
}

export interface CandidateOptions {
  /** Take the one vertex that is nearest, default false. */
  readonly oneVertex?: boolean;
  /** Take the whole part, default false. */
  readonly wholePart?: boolean;
  /** Take a flat side without the rounded edges around it, default false. */
  readonly flatSide?: boolean;
  /** File units: how large a spot is on a shape that has no lines to go by. */
  readonly spot: number;
}

/**
 * What a person means who clicks there: a line of the shape if one is near, the rim of an opening before others; else the smooth
 * patch up to the lines around it; where that is all of a part, the part. A shape of one part without any lines, such as a figure,
 * would be taken as a whole, which nobody means who points at its ear: there it is a round spot, the first dab of a brush.
 */
export function candidateAt(surface: SelectableMesh, aim: Aim, options: CandidateOptions): Candidate {
  if (options.oneVertex) return oneVertex(nearestVertex(surface, aim));
  if (options.wholePart) return partOf(surface, aim.face);
  const near = nearestFeature(surface, aim);
  const line = near && lineAt(surface, near.edge, near.isBorder);
  if (line && isLargeEnough(line, aim)) return line;
  const side = options.flatSide && flatSideAt(surface, aim.face);
  if (side && isLargeEnough(side, aim)) return side;
  if (!isAllOfItsPart(surface, aim.face)) {
    const patch = patchOf(surface, aim.face);
    if (isLargeEnough(patch, aim)) return patch;
  } else if (surface.parts.count > 1) return partOf(surface, aim.face);
  return spotAt(surface, aim, options.spot);
}

/** What is smaller on the screen than so many times the pointer's reach is a crumb of a rough surface: nobody points at it. */
const leastReaches = 3;

function isLargeEnough({ vertices }: Candidate, { project, reach }: Aim): boolean {
  let [left, top, right, bottom] = [Infinity, Infinity, -Infinity, -Infinity];
  for (const vertex of vertices) {
    const [x, y] = project(vertex);
    left = Math.min(left, x);
    right = Math.max(right, x);
    top = Math.min(top, y);
    bottom = Math.max(bottom, y);
    if (Math.max(right - left, bottom - top) >= leastReaches * reach) return true;
  }
  return false;
}

/** Of a part's faces: smaller patches are crumbs of a rough surface too, and cut nothing off. */
const crumbShare = 1e-3;

const whole = new WeakMap<SelectableMesh, Map<number, boolean>>();

/** Whether the patch of a face has all of its part but for crumbs. */
function isAllOfItsPart(surface: SelectableMesh, face: number): boolean {
  const known = whole.get(surface) ?? new Map<number, boolean>();
  whole.set(surface, known);
  const patch = surface.patches.of[face]!;
  const isWhole = known.get(patch) ?? hasOnlyCrumbsBeside(surface, face);
  known.set(patch, isWhole);
  return isWhole;
}

function hasOnlyCrumbsBeside(surface: SelectableMesh, face: number): boolean {
  const part = facesOfPart(surface, face);
  let left = part.length - facesOfPatch(surface, face).length;
  if (left > part.length / 2) return false;
  const { patches } = surface;
  const own = patches.of[face]!;
  const seen = new Set([own]);
  for (let k = 0; k < part.length && left > 0; k++) {
    const patch = patches.of[part[k]!]!;
    if (seen.has(patch)) continue;
    seen.add(patch);
    const { length } = facesOfPatch(surface, part[k]!);
    if (length >= crumbShare * part.length) return false;
    left -= length;
  }
  return true;
}

/** The part that a face belongs to. */
export function partOf(surface: SelectableMesh, face: number): Candidate {
  const { topology, parts } = surface;
  const part = parts.of[topology.triangles[3 * face]!]!;
  return remembered(surface, `part ${part}`, () => {
    const vertices = membersOf(parts, part);
    const faces = facesOfPart(surface, face);
    const whole = parts.count === 1 ? 'the whole shape' : 'a separate part';
    return { kind: 'part', vertices, edges: noEdges, faces, sentence: `${whole}, ${told(vertices)}` };
  });
}

/** The smooth patch that a face belongs to. */
export function patchOf(surface: SelectableMesh, face: number): Candidate {
  const patch = surface.patches.of[face]!;
  return remembered(surface, `patch ${patch}`, () => {
    const faces = facesOfPatch(surface, face);
    const vertices = verticesOfFaces(surface, faces);
    const edges = outlineOf(surface, patch);
    return { kind: 'patch', vertices, edges, faces, sentence: `a smooth patch of ${told(vertices)}` };
  });
}

function flatSideAt(surface: SelectableMesh, face: number): Candidate | null {
  const faces = flatSideOf(surface, face);
  if (!faces) return null;
  return remembered(surface, `flat side ${faces[0]}`, () => {
    const vertices = verticesOfFaces(surface, faces);
    const edges = outlineOfFaces(surface, faces);
    return { kind: 'patch', vertices, edges, faces, sentence: `a flat side of ${told(vertices)}` };
  });
}

function lineAt(surface: SelectableMesh, edge: number, isBorder: boolean): Candidate {
  const edges = isBorder ? boundaryLoop(surface, edge) : featureLoop(surface, edge);
  const { ends } = surface.topology;
  const drawn = new Uint32Array(2 * edges.length);
  edges.forEach((one, i) => {
    drawn.set(ends.subarray(2 * one, 2 * one + 2), 2 * i);
  });
  const vertices = Uint32Array.from(new Set(drawn));
  const what = isBorder
    ? 'the rim of an opening'
    : vertices.length === edges.length
      ? 'an edge all around'
      : 'an edge';
  return {
    kind: isBorder ? 'rim' : 'line',
    vertices,
    edges: drawn,
    faces: noFaces,
    sentence: `${what}, ${told(vertices)}`,
  };
}

function spotAt(surface: SelectableMesh, aim: Aim, radius: number): Candidate {
  const vertices = discAround(surface, aim, radius);
  return {
    kind: 'spot',
    vertices,
    edges: noEdges,
    faces: facesInside(surface, vertices),
    sentence: `a round spot of ${told(vertices)}, as there are no edges to go by; drag to brush`,
  };
}

function oneVertex(vertex: number): Candidate {
  const vertices = Uint32Array.of(vertex);
  return { kind: 'vertex', vertices, edges: noEdges, faces: noFaces, sentence: 'one vertex' };
}

const noEdges = new Uint32Array(0);
const noFaces = new Uint32Array(0);

const count = new Intl.NumberFormat('en');

/** "1 vertex", "22,592 vertices". */
function told({ length }: ArrayLike<number>): string {
  return length === 1 ? '1 vertex' : `${count.format(length)} vertices`;
}

const made = new WeakMap<SelectableMesh, Map<string, Candidate>>();

/** Patches and parts can be large: a pointer that stays on one finds it made. */
function remembered(surface: SelectableMesh, key: string, make: () => Candidate): Candidate {
  const ofSurface = made.get(surface) ?? new Map<string, Candidate>();
  made.set(surface, ofSurface);
  const candidate = ofSurface.get(key) ?? make();
  ofSurface.set(key, candidate);
  return candidate;
}
