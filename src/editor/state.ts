import type { FailureCode } from '../mesh/failure.ts';
import type { History } from './history.ts';
import { emptyHistory } from './history.ts';
import type { Project } from './project.ts';

export type Activity =
  | { readonly kind: 'idle' }
  | { readonly kind: 'opening'; readonly name: string }
  | { readonly kind: 'writing'; readonly name: string }
  | {
      readonly kind: 'solving';
      /** The id of the step that runs. */
      readonly step: number;
      /** Following a gesture, or settling what it left. */
      readonly live: boolean;
      /** What is being prepared, and how far that is, 0 to 1; null once it iterates. */
      readonly preparing: { readonly stage: string; readonly share: number } | null;
      readonly iteration: number;
      readonly energy: readonly number[];
    };

export const idle: Activity = Object.freeze({ kind: 'idle' });

/** Something to tell a person. It stays until it is dismissed or replaced. */
export interface Notice {
  readonly tone: 'error' | 'note';
  readonly text: string;
  /** What an error is an error of; a sentence of the page alone has none. */
  readonly code?: FailureCode;
  readonly action?: { readonly label: string; readonly run: () => void };
}

/** Tells a person of warnings, if there are any. */
export function noticeOf(warnings: readonly string[]): Pick<Partial<EditorState>, 'notice'> {
  return warnings.length > 0 ? { notice: { tone: 'note', text: warnings.join(' ') } } : {};
}

/** What an editor has and does. */
export interface EditorState {
  readonly project: Project | null;
  readonly history: History;
  readonly activity: Activity;
  readonly notice: Notice | null;
}

export const emptyState: EditorState = { project: null, history: emptyHistory, activity: idle, notice: null };

/** Where an editor keeps its state: the page's has more in it. */
export interface EditorStore {
  readonly state: EditorState;
  set(change: Partial<EditorState>): void;
}

export type Listener<State> = (state: State) => void;

/** One state and those who look at it. */
export class Store<State extends object> {
  #state: State;
  readonly #listeners = new Set<Listener<State>>();

  constructor(state: State) {
    this.#state = state;
  }

  get state(): State {
    return this.#state;
  }

  set(change: Partial<State>): void {
    this.#state = { ...this.#state, ...change };
    for (const listener of this.#listeners) listener(this.#state);
  }

  /** Calls the listener on every change from now on, until the returned function is called. */
  subscribe(listener: Listener<State>): () => void {
    this.#listeners.add(listener);
    return () => this.#listeners.delete(listener);
  }
}
