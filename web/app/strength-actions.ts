import type { Editor } from '../../src/editor/editor.ts';
import { freeName } from '../../src/editor/free-name.ts';
import { activeStep, type Step } from '../../src/editor/project.ts';
import type { StepChange } from '../../src/editor/steps.ts';
import { sharesOf, withPaintedStrength, withShares } from '../../src/editor/strength.ts';
import { pngOfSphereField, sphereFieldOfImage } from '../../src/inputs/fields/read-sphere-field.ts';
import { at, toFailure } from '../../src/mesh/failure.ts';
import { weldOf } from '../../src/mesh/weld.ts';
import { findMethod } from '../../src/methods/registry.ts';
import { fieldParameter, strengthParameter } from '../../src/methods/set-by-hand.ts';
import type { ParameterValues } from '../../src/methods/values/index.ts';
import type { SphereField } from '../../src/methods/values/sphere-field.ts';
import type { PageStore } from './page-state.ts';
import { readImage } from './read-image.ts';
import { saveFile } from './save.ts';

/** What strength is to become; null takes away what was painted, undefined leaves it. */
export interface StrengthChange {
  /** Share of λ for each welded vertex, #V; not changed any more. */
  readonly shares?: Float64Array | null;
  /** Share for each direction. */
  readonly field?: SphereField | null;
}

/** Where the style of the active step is strong: on the surface and by direction. */
export class StrengthActions {
  readonly #store: PageStore;
  readonly #editor: Editor;

  constructor(store: PageStore, editor: Editor) {
    this.#store = store;
    this.#editor = editor;
  }

  /** Whether the step has a strength to paint on the surface. */
  get isOnSurface(): boolean {
    return strengthParameter(findMethod(this.#step?.method ?? '')) !== undefined;
  }

  /** Whether it has one by direction. */
  get isOnBall(): boolean {
    return this.#fieldName !== undefined;
  }

  /** Shares of the welded vertices; null where nobody has painted. */
  get shares(): Float64Array | null {
    const { project } = this.#store.state;
    return project && sharesOf(activeStep(project), weldOf(project.mesh));
  }

  /** Shares of directions; null where nobody has painted, or what is named is not known yet. */
  get field(): SphereField | null {
    const { project } = this.#store.state;
    const step = this.#step;
    if (!project || !step || this.#fieldName === undefined) return null;
    const value = step.parameters[this.#fieldName] as string | SphereField | undefined;
    if (typeof value !== 'string') return value ?? null;
    const asset = project.assets.get(value);
    if (asset?.kind === 'sphere-field') return asset.field;
    const resolved = step.result?.of.method === step.method && step.result.resolved[this.#fieldName];
    return (resolved as SphereField | undefined) || null;
  }

  preview(change: StrengthChange): void {
    if (this.#step) this.#editor.preview(this.#change(change));
  }

  /** One entry for undo. */
  commit(change: StrengthChange, label = 'Paint strength'): void {
    if (this.#step) this.#editor.commit(this.#change(change), label);
  }

  /** Takes back the gesture that is under way. */
  cancel(): void {
    this.#editor.dropGesture();
  }

  /** Values of the active step with another λ: what was painted is a share of it. */
  rescaled(values: ParameterValues): ParameterValues {
    const { project } = this.#store.state;
    return project ? withPaintedStrength(activeStep(project), values, weldOf(project.mesh)) : values;
  }

  /** Saves the ball as the PNG that recipes name. */
  saveBall(): void {
    const { field } = this;
    if (field) saveFile(new Blob([pngOfSphereField(field)], { type: 'image/png' }), this.#ballName());
  }

  async loadBall(file: File): Promise<void> {
    try {
      const bytes = new Uint8Array(await file.arrayBuffer());
      const field = sphereFieldOfImage(await at(file.name, readImage(bytes, file.name)), file.name);
      this.commit({ field }, 'Load a ball');
    } catch (thrown) {
      this.#store.set({ notice: { tone: 'error', text: toFailure(thrown).message } });
    }
  }

  get #step(): Step | null {
    const { project } = this.#store.state;
    return project && activeStep(project);
  }

  get #fieldName(): string | undefined {
    return fieldParameter(findMethod(this.#step?.method ?? ''));
  }

  #change({ shares, field }: StrengthChange): StepChange {
    const project = this.#store.state.project!;
    const step = activeStep(project);
    const parameters =
      shares === undefined ? step.parameters : withShares(step, shares, weldOf(project.mesh));
    const name = this.#fieldName;
    if (field === undefined || name === undefined) return { parameters };
    const { [name]: _, ...others } = parameters;
    if (!field) return { parameters: others };
    const ball = this.#ballName();
    const assets = new Map([[ball, { kind: 'sphere-field', field } as const]]);
    return { parameters: { ...others, [name]: ball }, assets };
  }

  /** What recipes call the ball of the active step; the balls of other steps keep theirs. */
  #ballName(): string {
    const { project } = this.#store.state;
    const others = project?.steps.filter(({ id }) => id !== project.active) ?? [];
    return freeName(paintedBall, (name) => others.some((step) => names(step).includes(name)));
  }
}

const paintedBall = 'strength.png';

function names({ parameters, remembered }: Step): readonly unknown[] {
  return [parameters, ...Object.values(remembered)].flatMap((values) => Object.values(values));
}
