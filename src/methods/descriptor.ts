import type { MeshReport } from '../mesh/mesh.ts';
import type { GaussMap } from './values/gauss-map.ts';
import type { Relief } from './values/texture-slopes.ts';

/** What a change of a parameter makes the core recompute; each includes those before it. */
export type Invalidates = 'targets' | 'weights' | 'system' | 'all';

interface Parameter {
  /** The one name on page, element, command line (in kebab-case), recipe and C++ registry. */
  readonly name: string;
  /** What a person reads beside the control. */
  readonly label: string;
  /** One line of documentation, with the paper's section where there is one. */
  readonly doc: string;
  readonly invalidates: Invalidates;
  /** Shown behind "More" in the panel. */
  readonly advanced?: boolean;
  /** Says how another parameter's value is made out; the core does not know it. */
  readonly isForLibrary?: boolean;
}

export interface NumberParameter extends Parameter {
  readonly kind: 'number' | 'integer';
  readonly default: number;
  /** Hard range, inclusive; the core refuses what lies outside. */
  readonly min: number;
  readonly max: number;
  /** Unit as shown to people, '' for a pure number. */
  readonly unit: string;
  /** The range that looks good, for sliders. */
  readonly slider?: { readonly min: number; readonly max: number; readonly step: number };
}

export interface ChoiceParameter extends Parameter {
  readonly kind: 'choice';
  readonly default: string;
  readonly choices: readonly string[];
  /** Set where a list of {@link Directions} will do in place of a name, their lengths counting: how many at most. */
  readonly maxRows?: number;
}

/** A fixed count of numbers, as many as its default has. */
export interface VectorParameter extends Parameter {
  readonly kind: 'vector';
  readonly default: readonly number[];
  /** Hard range of each number, inclusive. */
  readonly min: number;
  readonly max: number;
}

/** A {@link Quaternion}. */
export interface RotationParameter extends Parameter {
  readonly kind: 'rotation';
  readonly default: Quaternion;
}

/** Something that is done or not. */
export interface FlagParameter extends Parameter {
  readonly kind: 'flag';
  readonly default: boolean;
}

/** A number for each vertex of the source file's position list: a {@link Scalars} value. Absent or empty means none. */
export interface ScalarsParameter extends Parameter {
  readonly kind: 'scalars';
  /** Hard range of each number, inclusive. */
  readonly min: number;
  readonly max: number;
}

/**
 * A rotation for parts of the mesh: {@link Regions}, of which the engine makes one for each vertex. Absent or empty means none.
 */
export interface RotationsParameter extends Parameter {
  readonly kind: 'rotations';
}

/**
 * A style. In a recipe or on the command line a {@link StyleName} or {@link Directions}, which `resolveStyle` of `src/inputs/styles`
 * turns into the {@link GaussMap} that the engine takes.
 */
export interface StyleParameter extends Parameter {
  readonly kind: 'style';
  /** Set where only a few directions will do: those of a convex shape, or a list of them. */
  readonly mapping?: 'closest';
  /** What page and command line take when nothing is said; the engine itself has none. */
  readonly default: string;
}

/**
 * A picture that lies on the mesh by its texture coordinates. In a recipe or on the command line an {@link ImageName}, which
 * `src/inputs/images` turns into the {@link Relief} that the engine takes.
 */
export interface ReliefParameter extends Parameter {
  readonly kind: 'relief';
}

/** Vertices held at given places: a {@link Handles} value. Absent means none. */
export interface HandlesParameter extends Parameter {
  readonly kind: 'handles';
}

export type ParameterDescriptor =
  | NumberParameter
  | ChoiceParameter
  | FlagParameter
  | VectorParameter
  | RotationParameter
  | ScalarsParameter
  | RotationsParameter
  | StyleParameter
  | ReliefParameter
  | HandlesParameter;

/** The normals that a method draws the mesh's to. */
export interface StyleTargets {
  /** The parameter whose value, or name, tells the style. */
  readonly style: string;
  /** Whose normals the targets are looked up from: the input's once, or the output's as it goes. */
  readonly lookedUpFrom: 'input' | 'output';
}

/** What values to start from depend on. */
export interface StartingPoint {
  readonly report: MeshReport;
  /** The style that the method is to take, if it takes one and one was chosen. */
  readonly style: GaussMap | null;
}

/** A method as page, recipe, command line and element see it. */
export interface MethodDescriptor {
  readonly id: string;
  readonly title: string;
  /** One sentence for the panel and `whittle methods`. */
  readonly summary: string;
  readonly paper: string;
  /** How its results are looked at best: boxes and folded sheets by their faces. */
  readonly shading: 'smooth' | 'flat';
  /** What normals are drawn to, for these values; absent where the method has no targets that a style tells. */
  readonly targets?: (values: ParameterValues) => StyleTargets;
  /** Values that suit a mesh and a style better than the defaults. */
  readonly startingValues?: (about: StartingPoint) => ParameterValues;
  readonly parameters: readonly ParameterDescriptor[];
}

/** Vertices (indices of the source file's position list) and where they are to go, in the file's own units. */
export interface Handles {
  readonly vertices: readonly number[];
  readonly targets: readonly (readonly [number, number, number])[];
}

/** A number for each vertex, by the source file's position list. */
export type Scalars = readonly number[] | Float64Array;

/** A rotation as glTF and three.js write it, of any length but zero. */
export type Quaternion = readonly [x: number, y: number, z: number, w: number];

/** Vertices (indices of the source file's position list) and how they are turned; no vertex is in two of them. */
export type Regions = readonly { readonly vertices: readonly number[]; readonly orientation: Quaternion }[];

/** A primitive ('cube'), a style mesh ('oloid') or the path of a mesh file. */
export type StyleName = string;

/** Vectors of any length but zero: normals to snap to, or the rows of a polyhedron's matrix. */
export type Directions = readonly (readonly [x: number, y: number, z: number])[];

/** A pattern of ours ('weave') or the path of a picture. */
export type ImageName = string;

export type ParameterValue =
  | number
  | string
  | boolean
  | Scalars
  | Regions
  | GaussMap
  | Directions
  | Relief
  | Handles;
/** Values by parameter name; what is absent has its default. */
export type ParameterValues = Readonly<Record<string, ParameterValue>>;
