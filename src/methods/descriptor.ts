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
}

/** Vertices held at given places: a {@link Handles} value. Absent means none. */
export interface HandlesParameter extends Parameter {
  readonly kind: 'handles';
}

export type ParameterDescriptor = NumberParameter | ChoiceParameter | HandlesParameter;

/** A method as page, recipe, command line and element see it. */
export interface MethodDescriptor {
  readonly id: string;
  readonly title: string;
  /** One sentence for the panel and `whittle methods`. */
  readonly summary: string;
  readonly paper: string;
  readonly parameters: readonly ParameterDescriptor[];
}

/** Vertices (indices of the source file's position list) and where they are to go, in the file's own units. */
export interface Handles {
  readonly vertices: readonly number[];
  readonly targets: readonly (readonly [number, number, number])[];
}

export type ParameterValue = number | string | Handles;
/** Values by parameter name; what is absent has its default. */
export type ParameterValues = Readonly<Record<string, ParameterValue>>;
