import type { Progress } from '../engine/protocol.ts';

/** The part of a stream that progress needs. */
export interface ProgressStream {
  readonly isTTY?: boolean;
  readonly columns?: number;
  write(text: string): unknown;
}

/** One line that is written over and over, on a terminal only. */
export class ProgressLine {
  readonly #stream: ProgressStream | undefined;

  constructor(stream: ProgressStream, quiet: boolean) {
    this.#stream = stream.isTTY && !quiet ? stream : undefined;
  }

  /** A listener for the progress of one step. */
  follow(step: string): (progress: Progress) => void {
    const began = performance.now();
    this.show(step);
    return (progress) => {
      const seconds = ((performance.now() - began) / 1000).toFixed(1);
      this.show(`${step}  ${inWords(progress)}  ${seconds} s`);
    };
  }

  show(text: string): void {
    this.#stream?.write(`\r${text.slice(0, (this.#stream.columns || 80) - 1)}\x1b[K`);
  }

  clear(): void {
    this.#stream?.write('\r\x1b[K');
  }
}

function inWords(progress: Progress): string {
  if (progress.kind === 'preparing') return `${progress.stage}, ${Math.round(100 * progress.share)} %`;
  return `iteration ${progress.iteration}  change ${progress.change.at(-1)?.toExponential(1)}`;
}
