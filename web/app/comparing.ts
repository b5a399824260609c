import { Comparison, type Picture } from '../../src/editor/comparison.ts';
import type { Editor } from '../../src/editor/editor.ts';
import { activeStep, type Project } from '../../src/editor/project.ts';
import type { Engine } from '../../src/engine/client.ts';
import type { Mesh } from '../../src/mesh/mesh.ts';
import { findMethod } from '../../src/methods/registry.ts';
import { comparedParameter } from '../../src/methods/set-by-hand.ts';
import type { ChoiceParameter } from '../../src/methods/values/choice.ts';
import { type Box, isInside } from '../../src/viewer/box.ts';
import type { Interaction } from '../../src/viewer/interaction.ts';
import { SideBySide } from '../../src/viewer/side-by-side.ts';
import type { PageStore } from './page-state.ts';

export interface ComparingParts {
  readonly store: PageStore;
  readonly editor: Editor;
  readonly engine: Engine;
  /** Null where the browser draws no 3D. */
  readonly interaction: Interaction | null;
  /** Resolves when what was drawn last is on the screen. */
  readonly drawn: () => Promise<void>;
}

/** As many pictures, the one that is worked on among them, on a screen and on a phone. */
export const mostPictures = { wide: 4, narrow: 2 } as const;

/** The active step with several values of one parameter, side by side: all that buttons, keys and the canvas can ask for. */
export class Comparing {
  readonly #store: PageStore;
  readonly #editor: Editor;
  readonly #interaction: Interaction | null;
  readonly #side: SideBySide | null;
  readonly #parts: ComparingParts;
  #comparison: Comparison | null = null;
  #mesh: Mesh | null = null;
  /** By which the pictures differ. */
  #by: string | undefined;
  /** The value that the step had when it was looked at last. */
  #own: string | null = null;
  /** The page is as wide as a phone. */
  isNarrow = false;

  constructor(parts: ComparingParts) {
    this.#parts = parts;
    this.#store = parts.store;
    this.#editor = parts.editor;
    this.#interaction = parts.interaction;
    this.#side = parts.interaction && new SideBySide(parts.interaction.viewer);
    parts.store.subscribe(({ project }) => this.#follow(project));
    if (parts.interaction) this.#listen(parts.interaction.viewer.canvas);
  }

  /** What the active step can be compared by; undefined where there is nothing, or nothing is drawn. */
  get parameter(): ChoiceParameter | undefined {
    const { project } = this.#store.state;
    return project && this.#side ? comparedParameter(findMethod(activeStep(project).method)) : undefined;
  }

  get isOn(): boolean {
    return this.#store.state.compared.length > 0;
  }

  get most(): number {
    const choices = this.parameter?.choices.length ?? 1;
    return Math.min(choices, this.isNarrow ? mostPictures.narrow : mostPictures.wide);
  }

  /** The value of the step itself. */
  get own(): string {
    const { project } = this.#store.state;
    const { parameter } = this;
    const value = project && parameter && activeStep(project).parameters[parameter.name];
    return typeof value === 'string' ? value : (parameter?.default ?? '');
  }

  /** The other values, and what they give. */
  get pictures(): readonly Picture[] {
    return this.#comparison?.pictures ?? [];
  }

  toggle(): void {
    if (!this.leave()) this.add();
  }

  /** @returns whether there was anything to leave */
  leave(): boolean {
    if (!this.isOn) return false;
    this.#show([]);
    return true;
  }

  /** One more value, the first that is not there. */
  add(): void {
    const { compared } = this.#store.state;
    const next = this.parameter?.choices.find((one) => one !== this.own && !compared.includes(one));
    if (next !== undefined && compared.length + 1 < this.most) this.#show([...compared, next]);
  }

  remove(picture: number): void {
    this.#show(this.#store.state.compared.toSpliced(picture, 1));
  }

  /** Puts another value in a picture; one that is there already changes places with it. */
  change(picture: number, value: string): void {
    const { compared } = this.#store.state;
    if (value === this.own) {
      this.adopt(picture);
      return;
    }
    const before = compared[picture]!;
    this.#show(compared.map((one, k) => (k === picture ? value : one === value ? before : one)));
  }

  /** Makes a picture's value the step's own; what it was is compared in its place. */
  adopt(picture: number): void {
    const { compared } = this.#store.state;
    const value = compared[picture];
    if (value !== undefined) this.choose(value);
  }

  /** Gives the step another value; one entry for undo. */
  choose(value: string): void {
    const { parameter, own } = this;
    const { compared, project } = this.#store.state;
    if (!parameter || !project || value === own) return;
    const shown = this.pictures.find((one) => one.value === value)?.result ?? undefined;
    const known = shown?.state === 'settled' ? shown : undefined;
    // While the step's result is there: it is shown in the picture that goes.
    const swapped = compared.map((one) => (one === value ? own : one));
    this.#comparison?.compare(parameter.name, swapped);
    const parameters = { ...activeStep(project).parameters, [parameter.name]: value };
    this.#editor.commit({ parameters }, parameter.label, known);
  }

  /** Draws the pictures in these boxes, the step's own in the first; with one box or none that is all. */
  layOut(frames: readonly Box[]): void {
    const mesh = this.#store.state.project?.mesh;
    const [first, ...others] = frames;
    if (!mesh || !first) return;
    this.#side?.show(mesh, first, others);
    this.#interaction?.keepWithin(others.length > 0 ? first : null);
    this.#comparison?.redraw();
  }

  #show(compared: readonly string[]): void {
    const { parameter } = this;
    if (!parameter || compared.length === 0) {
      this.#comparison?.dispose();
      this.#comparison = null;
    } else {
      this.#comparison ??= this.#begin();
      this.#comparison.compare(parameter.name, compared);
    }
    this.#mesh = this.#store.state.project?.mesh ?? null;
    this.#by = parameter?.name;
    this.#own = this.#own ?? this.own;
    this.#store.set({ compared });
  }

  #begin(): Comparison {
    const { store, engine, drawn } = this.#parts;
    this.#own = this.own;
    return new Comparison({
      store,
      engine,
      resolver: this.#editor.resolver,
      isFollowing: () => this.#editor.isFollowing,
      draw: (picture, positions) => {
        this.#side?.update(picture, positions);
        return drawn();
      },
      changed: () => store.set({}),
    });
  }

  /** Another mesh or parameter has nothing to do with what is compared; a value that the step takes from a picture goes the other way. */
  #follow(project: Project | null): void {
    if (!this.isOn) return;
    const { parameter, own } = this;
    if (!project || project.mesh !== this.#mesh || parameter?.name !== this.#by) {
      this.leave();
      return;
    }
    const before = this.#own;
    this.#own = own;
    const { compared } = this.#store.state;
    if (before !== null && before !== own && compared.includes(own))
      this.#show(compared.map((one) => (one === own ? before : one)));
  }

  /** A click on a picture adopts it; dragging there turns all of them. */
  #listen(canvas: HTMLElement): void {
    let from: { readonly x: number; readonly y: number; readonly picture: number } | null = null;
    canvas.addEventListener('pointerdown', (event) => {
      const picture = this.#pictureAt(event);
      from = event.isPrimary && event.button === 0 && picture >= 0 ? { ...placeOf(event), picture } : null;
    });
    canvas.addEventListener('pointerup', (event) => {
      const at = placeOf(event);
      const still = event.pointerType === 'touch' ? 10 : 4;
      if (from && Math.hypot(at.x - from.x, at.y - from.y) <= still) this.adopt(from.picture);
      from = null;
    });
    canvas.addEventListener('pointercancel', () => {
      from = null;
    });
  }

  /** The picture under a pointer, or −1. */
  #pictureAt(event: PointerEvent): number {
    const { x, y } = placeOf(event);
    return this.#store.state.frames.slice(1).findIndex((frame) => isInside(frame, x, y));
  }
}

function placeOf(event: PointerEvent): { x: number; y: number } {
  const { left, top } = (event.currentTarget as HTMLElement).getBoundingClientRect();
  return { x: event.clientX - left, y: event.clientY - top };
}
