/** Every way in which Whittle can refuse or fail, by name. The core's codes cross to TypeScript by these names too. */
export const failureCodes = [
  // The file could not be understood (io)
  'unknown-format',
  'empty-file',
  'truncated-file',
  'malformed-file',
  'unsupported-file',
  // The mesh cannot be worked on (core, mesh/validate)
  'no-faces',
  'index-out-of-range',
  'not-finite',
  'zero-extent',
  'too-large',
  'unsuitable-mesh',
  // The request cannot be carried out
  'unknown-method',
  'bad-parameter',
  'bad-handles',
  'bad-planes',
  'bad-recipe',
  'out-of-memory',
  'numerical-failure',
  'worker-lost',
  'internal',
] as const;

export type FailureCode = (typeof failureCodes)[number];

/** A failure as plain data: it crosses the worker border unchanged. */
export interface Failure {
  readonly code: FailureCode;
  /** One sentence: what is wrong, where, and what to do about it. */
  readonly message: string;
  /** Index of the offending element (vertex, face or line, as the message says), or undefined. */
  readonly element?: number;
}

/** The only error class of the library; `code` is stable, `message` is for people. */
export class WhittleError extends Error implements Failure {
  override readonly name = 'WhittleError';
  readonly code: FailureCode;
  readonly element?: number;

  constructor(code: FailureCode, message: string, element?: number) {
    super(message);
    this.code = code;
    if (element !== undefined) this.element = element;
  }

  static from(failure: Failure): WhittleError {
    return new WhittleError(failure.code, failure.message, failure.element);
  }
}

/** The work's value, or its `WhittleError` with a place put before the sentence, unless it says it already or there is no place. */
export async function at<T>(place: string, work: Promise<T> | (() => T | Promise<T>)): Promise<T> {
  try {
    return await (typeof work === 'function' ? work() : work);
  } catch (thrown) {
    if (!(thrown instanceof WhittleError) || thrown.message.startsWith(place)) throw thrown;
    throw new WhittleError(thrown.code, `${place}: ${thrown.message}`, thrown.element);
  }
}

/** Turns anything thrown into a {@link Failure}; what is not ours is an `internal` failure. */
export function toFailure(thrown: unknown): Failure {
  if (thrown instanceof WhittleError) {
    const { code, message, element } = thrown;
    return element === undefined ? { code, message } : { code, message, element };
  }
  const message = thrown instanceof Error ? thrown.message : String(thrown);
  if (thrown instanceof RangeError && /memory|allocation|array buffer/i.test(message)) {
    return { code: 'out-of-memory', message: 'There is not enough memory for this mesh; try a smaller one.' };
  }
  return { code: 'internal', message: `Something went wrong inside Whittle (${message}). Please report it.` };
}
