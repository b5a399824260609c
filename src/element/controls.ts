import { html, nothing } from 'lit';
import { activeStep } from '../editor/project.ts';
import type { EditorState } from '../editor/state.ts';
import type { StepChange } from '../editor/steps.ts';
import type { NumberParameter } from '../methods/values/number.ts';
import { mainNumber } from './beginning.ts';

/** What the controls do. */
export interface ControlActs {
  /** Comes any number of times, then one {@link commit}. */
  preview(change: StepChange): void;
  commit(change: StepChange, label: string): void;
  stop(): void;
  reset(): void;
}

/** A slider for the method's strength, a way to stop and a way back. */
export function controls({ project, activity }: EditorState, acts: ControlActs) {
  const step = project && activeStep(project);
  const number = mainNumber(step?.method);
  return html`
    <div class="controls" part="controls">
      ${step && number ? slider(number, step.parameters, acts) : nothing}
      ${activity.kind === 'solving' ? html`<button type="button" @click=${() => acts.stop()}>Stop</button>` : nothing}
      <button type="button" @click=${() => acts.reset()}>Reset</button>
    </div>`;
}

function slider(
  { name, label, slider, min, max }: NumberParameter,
  values: NonNullable<StepChange['parameters']>,
  acts: ControlActs,
) {
  const changed = (event: Event): StepChange => ({
    parameters: { ...values, [name]: (event.target as HTMLInputElement).valueAsNumber },
  });
  return html`<label><span>${label}</span><input type="range" min=${slider?.min ?? min} max=${slider?.max ?? max} step=${slider?.step ?? 'any'} .value=${String(values[name])} @input=${(event: Event) => acts.preview(changed(event))} @change=${(event: Event) => acts.commit(changed(event), label)} /></label>`;
}
