import { type Combination, combined, type Selection } from '../../src/selection/index.ts';
import type { CanvasPointer } from '../../src/viewer/canvas-tool.ts';
import type { Interaction } from '../../src/viewer/interaction.ts';
import type { PageState, PageStore } from '../app/page-state.ts';
import type { PlaneActions } from '../app/plane-actions.ts';
import { brushSizes } from '../app/select-state.ts';
import type { Selecting } from '../app/selecting.ts';
import { type PlaneDrag, PlaneGrips } from './plane-grips.ts';
import { Seen } from './seen.ts';
import { BrushStroke, isStill, Outline, pointOf, type SelectGesture } from './select-gestures.ts';
import { SelectInk } from './select-ink.ts';
import { SelectLayers } from './select-layers.ts';
import { SelectView, type SelectViewParts } from './select-view.ts';
import type { Tool } from './tool.ts';

/** Two clicks within as many milliseconds take the whole part. */
const doubleClick = 400;

export interface SelectParts {
  readonly store: PageStore;
  readonly selecting: Selecting;
  readonly planes: PlaneActions;
  readonly interaction: Interaction;
  /** Runs something before the next picture. */
  readonly soon: (run: () => void) => void;
}

interface Press {
  readonly from: CanvasPointer;
  readonly before: Selection;
  readonly how: Combination;
  readonly view: SelectView;
  /** Null while the pointer is still where it was pressed. */
  gesture: SelectGesture | null;
}

/** Chooses vertices: what is pointed at, with a brush, by a lasso, by a frame. Shift adds, Ctrl takes away, Alt takes one vertex. */
export class SelectTool implements Tool {
  readonly cursor = 'crosshair';
  readonly #store: PageStore;
  readonly #parts: SelectViewParts;
  readonly #selecting: Selecting;
  readonly #interaction: Interaction;
  readonly #layers: SelectLayers;
  readonly #ink: SelectInk;
  readonly #planes: PlaneGrips;
  readonly #soon: (run: () => void) => void;
  #press: Press | null = null;
  /** A plane is being dragged. */
  #drag: PlaneDrag | null = null;
  #lastClick: { readonly at: CanvasPointer; readonly time: number } | null = null;
  #isDrawing = false;
  #leave: () => void = () => {};

  constructor(parts: SelectParts) {
    this.#store = parts.store;
    this.#selecting = parts.selecting;
    this.#interaction = parts.interaction;
    this.#layers = new SelectLayers(parts.interaction.layers);
    this.#planes = new PlaneGrips(parts);
    this.#soon = parts.soon;
    this.#ink = new SelectInk(parts.interaction.viewer.canvas);
    this.#parts = { ...parts, ink: this.#ink, seen: new Seen(parts.interaction.viewer) };
  }

  enter(): void {
    this.#selecting.want();
    this.#leave = this.#store.subscribe(() => this.#drawSoon());
    this.#drawSoon();
  }

  leave(): void {
    this.#leave();
    this.#layers.clear();
    this.#planes.clear();
    this.#ink.clear();
    this.#selecting.set({ pointed: null });
  }

  hover(pointer: CanvasPointer | null): void {
    const { way, brush } = this.#store.state.select;
    this.#ink.ring(pointer && way === 'brush' ? pointOf(pointer) : null, brush);
    const view = this.#view();
    this.#point(pointer && way === 'click' ? pointer : null, view);
    if (pointer) view?.prepare();
  }

  press(pointer: CanvasPointer): boolean {
    this.#drag = this.#planes.take(pointer);
    if (this.#drag) return true;
    const { way, combination, selection } = this.#store.state.select;
    const view = this.#view();
    if (!view || !selection) return false;
    const takesAnywhere = way === 'lasso' || way === 'box';
    // Beside the mesh the view is turned.
    if (!takesAnywhere && !this.#interaction.picking.pick(pointer)) return false;
    const how = pointer.shift ? 'add' : pointer.ctrl ? 'remove' : combination;
    this.#press = { from: pointer, before: selection, how, view, gesture: null };
    if (way === 'brush') this.#begin(this.#press).move(pointer);
    else if (way === 'click') this.#point(pointer, view);
    return true;
  }

  move(pointer: CanvasPointer): void {
    this.#drag?.move(pointer);
    const press = this.#press;
    if (!press) return;
    if (!press.gesture && isStill(press.from, pointer)) return;
    if (press.gesture instanceof BrushStroke || this.#store.state.select.way !== 'lasso') this.#ring(pointer);
    (press.gesture ?? this.#begin(press)).move(pointer);
  }

  release(pointer: CanvasPointer): void {
    this.#drag?.release(pointer);
    this.#drag = null;
    const press = this.#press;
    this.#press = null;
    if (!press) return;
    if (press.gesture) press.gesture.release(pointer);
    else this.#click(press);
    if (pointer.kind === 'touch') this.hover(null);
  }

  cancel(): void {
    this.#drag?.cancel();
    this.#drag = null;
    const press = this.#press;
    this.#press = null;
    this.#ink.clear();
    this.#point(null, null);
    if (press) this.#selecting.put(press.before);
  }

  key(event: KeyboardEvent): boolean {
    if (event.ctrlKey || event.metaKey || event.altKey) return false;
    const key = event.key.toLowerCase();
    if (key === 'escape') return this.#selecting.none();
    const does = selectKeys.find((one) => one.key === key)?.run;
    does?.(this.#selecting, this.#store.state);
    return does !== undefined;
  }

  /** What was a click becomes a brush once it is dragged. */
  #begin(press: Press): SelectGesture {
    const { way } = this.#store.state.select;
    const { view, before, how, from } = press;
    this.#point(null, null);
    if (way === 'lasso' || way === 'box')
      press.gesture = new Outline(view, before, how, { from, isBox: way === 'box' });
    else {
      press.gesture = new BrushStroke(view, before, how);
      press.gesture.move(from);
    }
    return press.gesture;
  }

  #click({ from, before, how, view }: Press): void {
    const last = this.#lastClick;
    const now = performance.now();
    const isDouble = last !== null && now - last.time < doubleClick && isStill(last.at, from);
    this.#lastClick = isDouble ? null : { at: from, time: now };
    const candidate = view.candidate(from, isDouble && !from.alt);
    if (candidate) view.put(combined(before, candidate.vertices, how));
  }

  #ring(pointer: CanvasPointer): void {
    const { way, brush } = this.#store.state.select;
    this.#ink.ring(way === 'click' || way === 'brush' ? pointOf(pointer) : null, brush);
  }

  /** Shows what a click there would take. */
  #point(pointer: CanvasPointer | null, view: SelectView | null): void {
    const { project, select } = this.#store.state;
    if (!project) return;
    const candidate = pointer && view ? view.candidate(pointer) : null;
    this.#layers.showCandidate(project.mesh, candidate);
    const pointed = candidate?.sentence ?? null;
    if (pointed !== select.pointed) this.#selecting.set({ pointed });
  }

  #view(): SelectView | null {
    const { project, select } = this.#store.state;
    const { surface } = this.#selecting;
    if (!project || !surface || !this.#interaction.viewer.space.surface) return null;
    return new SelectView(this.#parts, {
      mesh: project.mesh,
      surface,
      through: select.through,
      brush: select.brush,
    });
  }

  /** At most once a picture: strokes come faster than screens. */
  #drawSoon(): void {
    if (this.#isDrawing) return;
    this.#isDrawing = true;
    this.#soon(() => {
      this.#isDrawing = false;
      const { project, select, tool }: PageState = this.#store.state;
      if (project && tool === 'select')
        this.#layers.showSelection(this.#selecting.surface, project.mesh, select.selection);
      if (tool === 'select') this.#planes.show();
    });
  }
}

/** Keys of the tool. */
export interface SelectKey {
  /** As `KeyboardEvent.key`, lower case. */
  readonly key: string;
  readonly does: string;
  readonly run: (selecting: Selecting, state: PageState) => void;
}

const sized = (selecting: Selecting, { select }: PageState, factor: number) =>
  selecting.set({
    brush: Math.round(Math.min(brushSizes.most, Math.max(brushSizes.least, select.brush * factor))),
  });

export const selectKeys: readonly SelectKey[] = [
  { key: 'a', does: 'Select all', run: (selecting) => selecting.all() },
  { key: 'i', does: 'Select the rest instead', run: (selecting) => selecting.invert() },
  { key: '.', does: 'Grow the selection', run: (selecting) => selecting.grow() },
  { key: ',', does: 'Shrink the selection', run: (selecting) => selecting.shrink() },
  { key: 'm', does: 'Select the mirror image too', run: (selecting) => void selecting.mirror() },
  { key: ']', does: 'Larger brush', run: (selecting, state) => sized(selecting, state, 1.25) },
  { key: '[', does: 'Smaller brush', run: (selecting, state) => sized(selecting, state, 0.8) },
];
