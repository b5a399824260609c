import type { Weld } from '../../mesh/mesh.ts';

/** What a change of a parameter makes the core recompute; each includes those before it. */
export type Invalidates = 'targets' | 'weights' | 'system' | 'all';

/** What parameters of every kind have. */
export interface Parameter {
  /** The one name on page, element, command line (in kebab-case), recipe and in the core. */
  readonly name: string;
  /** What a person reads beside the control. */
  readonly label: string;
  /** One line of documentation, with the paper's section where there is one. */
  readonly doc: string;
  /** What the page says of it, in a person's words; {@link doc} where it has no control there. */
  readonly hint?: string;
  readonly invalidates: Invalidates;
  /** Among the settings of the solver, which the panel folds away. */
  readonly advanced?: boolean;
  /** Says how another parameter's value is made out; the core does not know it. */
  readonly isForLibrary?: boolean;
}

/** A value on its way to the core: `whittle_set_value` of `wasm/bindings/whittle.h` tells how each kind is laid out. */
export interface Encoded {
  /** The name of a choice, or of the form of a value that has several; '' for all others. */
  readonly name: string;
  readonly numbers: Float64Array;
  readonly indices: Uint32Array;
}

/** How the command line's help tells of a value. */
export interface ValueHelp {
  /** What stands for it after the flag. */
  readonly value: string;
  readonly range: string;
}

/**
 * All that the library knows of one kind of value. A new kind is one file with such an object, its line in `kinds` of
 * `index.ts`, and its twin in `wasm/core/methods/values`.
 */
export interface ValueKind<Descriptor extends Parameter, Value> {
  /** What is wrong with a value: the rest of a sentence that begins with the parameter's name. Undefined if nothing is. */
  readonly problem: (descriptor: Descriptor, value: unknown) => string | undefined;
  /** The code of a refusal; default `bad-parameter`. */
  readonly code?: 'bad-handles' | 'bad-planes';
  /**
   * Lays a value out for the core, vertices by their number in the welded mesh.
   *
   * @throws WhittleError where the mesh has no such vertex, and for the mere name of what the engine takes itself
   */
  readonly encode: (descriptor: Descriptor, value: Value, weld: Weld) => Encoded;
  readonly help: (descriptor: Descriptor) => ValueHelp;
  /** Whether a value may be a mere name, which `src/inputs` turns into what the engine takes. */
  readonly takesNames?: true;
  /** The value that was typed after a flag; text that looks wrong stays text, for {@link problem} to quote. Absent: see {@link isFile}. */
  readonly fromText?: (text: string) => unknown;
  /** Whether what was typed names a JSON file that holds the value. Absent: it does where nothing can be typed. */
  readonly isFile?: (descriptor: Descriptor, text: string) => boolean;
}

export const noNumbers = new Float64Array();
export const noIndices = new Uint32Array();

/** What has nothing but numbers. */
export function encodedNumbers(numbers: Iterable<number>): Encoded {
  return { name: '', numbers: Float64Array.from(numbers), indices: noIndices };
}
