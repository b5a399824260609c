import type { Outcome } from '../engine/protocol.ts';
import type { FailureCode } from '../mesh/failure.ts';

/** The events of `<whittle-view>`. They do not bubble. */
export interface ViewEventMap {
  /** The plain mesh is on the screen. */
  load: CustomEvent<{ readonly positions: number; readonly faces: number; readonly format: string }>;
  progress: CustomEvent<
    | {
        readonly phase: 'download' /** From 0 to 1; NaN where the server does not say how long the file is. */;
        readonly share: number;
      }
    | { readonly phase: 'prepare'; readonly stage: string /** From 0 to 1. */; readonly share: number }
    | { readonly phase: 'solve'; readonly iteration: number }
  >;
  /** A step has ended, and its shape is on the screen. */
  change: CustomEvent<{
    readonly method: string;
    readonly outcome: Outcome;
    readonly iterations: number;
    readonly state: 'settled' | 'stopped' | 'preview';
  }>;
  error: CustomEvent<{ readonly code: FailureCode; readonly message: string }>;
}
