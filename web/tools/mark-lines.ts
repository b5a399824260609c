import { weldOf } from '../../src/mesh/weld.ts';
import type { ChainRole, ChainsParameter } from '../../src/methods/values/chains.ts';
import { type Line, lineAt } from '../../src/selection/index.ts';
import type { CanvasPointer } from '../../src/viewer/canvas-tool.ts';
import type { Interaction } from '../../src/viewer/interaction.ts';
import type { LineActions } from '../app/line-actions.ts';
import type { PageStore } from '../app/page-state.ts';
import { Selectable } from '../app/selectable.ts';
import { aimAt, reachOf } from './aim.ts';
import { LineLayers } from './line-layers.ts';
import { ScreenMap } from './screen-map.ts';
import type { Tool } from './tool.ts';

export interface MarkParts {
  readonly store: PageStore;
  readonly interaction: Interaction;
  readonly lines: LineActions;
}

/** Lines that are marked, or whose marks are taken away, between a press and its release. */
interface Stroke {
  readonly parameter: ChainsParameter;
  readonly isMarking: boolean;
  readonly chains: (readonly number[])[];
}

/**
 * Marks lines along edges: a click takes the whole line that is meant, another takes its mark away; dragging marks all that it meets.
 * Shift only marks, Alt only takes away.
 */
export class MarkLines implements Tool {
  readonly cursor = 'crosshair';
  /** What lines are marked as. */
  role: ChainRole = 'crease';
  /** What a click would do, in words. */
  pointed: string | null = null;
  readonly #parts: MarkParts;
  readonly #layers: LineLayers;
  /** Its creases are those of the step. */
  readonly #surface = new Selectable(() => this.#parts.store.set({}));
  #stroke: Stroke | null = null;
  #unlisten: (() => void) | null = null;

  constructor(parts: MarkParts) {
    this.#parts = parts;
    this.#layers = new LineLayers(parts.interaction.layers);
  }

  enter(): void {
    this.#unlisten = this.#parts.store.subscribe(() => this.#show());
    this.#show();
  }

  leave(): void {
    this.#unlisten?.();
    this.#unlisten = null;
    this.#stroke = null;
    this.#layers.clear();
  }

  /** The parameter that lines are marked for; undefined where the step takes none. */
  get parameter(): ChainsParameter | undefined {
    const { parameters } = this.#parts.lines;
    return parameters.find(({ role }) => role === this.role) ?? parameters[0];
  }

  choose(role: ChainRole): void {
    this.role = role;
    this.#parts.store.set({});
  }

  hover(pointer: CanvasPointer | null): void {
    const line = pointer && this.#lineAt(pointer);
    const { project } = this.#parts.store.state;
    const { parameter } = this;
    this.#layers.point(project?.mesh ?? null, line, parameter?.role ?? this.role);
    const isMarked = line !== null && parameter !== undefined && this.#isMarked(parameter, line);
    const how = isMarked ? 'takes the mark from' : 'marks';
    this.#say(line && `A click ${how} a line of ${line.edges.length} edges.`);
    this.#parts.interaction.viewer.invalidate();
  }

  press(pointer: CanvasPointer): boolean {
    const { parameter } = this;
    if (!parameter || !this.#parts.interaction.picking.pick(pointer)) return false;
    const line = this.#lineAt(pointer);
    const isMarking = pointer.shift || (!pointer.alt && !(line && this.#isMarked(parameter, line)));
    this.#stroke = { parameter, isMarking, chains: [] };
    this.#take(line);
    return true;
  }

  move(pointer: CanvasPointer): void {
    this.#take(this.#lineAt(pointer));
  }

  release(pointer: CanvasPointer): void {
    const stroke = this.#stroke;
    this.#stroke = null;
    if (stroke && stroke.chains.length > 0)
      this.#parts.lines.mark(stroke.parameter, stroke.chains, stroke.isMarking);
    this.#show();
    this.hover(pointer.kind === 'touch' ? null : pointer);
  }

  cancel(): void {
    this.#stroke = null;
    this.hover(null);
    this.#show();
  }

  #take(line: Line | null): void {
    if (!this.#stroke || !line) return;
    this.#stroke.chains.push(this.#inFile(line));
    this.#show();
  }

  #lineAt(pointer: CanvasPointer): Line | null {
    const { store, interaction, lines } = this.#parts;
    const { project } = store.state;
    const { parameter } = this;
    const selectable = project && this.#surface.of(project, lines.angle);
    const hit = selectable && parameter ? interaction.picking.pick(pointer) : null;
    if (!hit) return null;
    const map = new ScreenMap(interaction.viewer, weldOf(project!.mesh).positionOfVertex);
    return lineAt(selectable!, aimAt(hit, pointer, map, reachOf[pointer.kind]), parameter!.role);
  }

  #isMarked(parameter: ChainsParameter, line: Line): boolean {
    return this.#parts.lines.has(parameter, this.#inFile(line));
  }

  #inFile({ vertices }: Line): readonly number[] {
    const { positionOfVertex } = weldOf(this.#parts.store.state.project!.mesh);
    return vertices.map((vertex) => positionOfVertex[vertex]!);
  }

  #say(sentence: string | null): void {
    if (sentence === this.pointed) return;
    this.pointed = sentence;
    this.#parts.store.set({});
  }

  #show(): void {
    const { store, lines } = this.#parts;
    const { project } = store.state;
    const stroke = this.#stroke;
    const marked = lines.parameters.map((parameter) => ({
      role: parameter.role,
      chains: lines.of(parameter),
    }));
    this.#layers.show(project && this.#surface.of(project, lines.angle), project?.mesh ?? null, marked);
    this.#layers.stroke(stroke && { role: stroke.parameter.role, chains: stroke.chains });
  }
}
