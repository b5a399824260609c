import { html, nothing } from 'lit';
import { repeat } from 'lit/directives/repeat.js';
import type { Step } from '../../src/editor/project.ts';
import { imageParameter, styleParameter } from '../../src/editor/starting-step.ts';
import { findMethod } from '../../src/methods/registry.ts';
import { icon } from './icons.ts';
import { PageElement } from './page-element.ts';

/**
 * The steps, first to last: each works on what the one before left. A click goes back into a step, its box switches it off, the
 * arrows of the step that is edited move it. A single step needs no list.
 */
export class WhittleStack extends PageElement {
  protected override render() {
    const steps = this.state.project?.steps ?? [];
    if (steps.length < 2) return nothing;
    return html`
      <ol class="stack" aria-label="Steps">
        ${repeat(
          steps,
          ({ id }) => id,
          (step, place) => this.#row(step, place),
        )}
      </ol>`;
  }

  #row(step: Step, place: number) {
    const { activity, project } = this.state;
    const isActive = step.id === project!.active;
    const isBusy = activity.kind === 'solving' && activity.step === step.id;
    const name = nameOf(step);
    const { editor } = this.page;
    return html`
      <li data-step=${place + 1} ?data-active=${isActive} ?data-busy=${isBusy} ?data-off=${!step.isOn}>
        <input type="checkbox" .checked=${step.isOn} aria-label="${name} is on" title=${step.isOn ? 'Switch it off' : 'Switch it on'} @change=${() => editor.switchStep(step.id, !step.isOn)} />
        <button type="button" class="step-name" title=${name} aria-current=${isActive ? 'step' : nothing} @click=${() => editor.activate(step.id)}><span class="place">${place + 1}</span>${name}</button>
        ${isActive ? this.#moves(step, place, name) : nothing}
      </li>`;
  }

  #moves({ id }: Step, place: number, name: string) {
    const last = this.state.project!.steps.length - 1;
    const { editor } = this.page;
    return html`
      <button type="button" class="step-act" data-act="step-up" ?disabled=${place === 0} aria-label="Move ${name} up" title="Earlier" @click=${() => editor.moveStep(id, place - 1)}>${icon('up')}</button>
      <button type="button" class="step-act" data-act="step-down" ?disabled=${place === last} aria-label="Move ${name} down" title="Later" @click=${() => editor.moveStep(id, place + 1)}>${icon('down')}</button>
      <button type="button" class="step-act" data-act="step-remove" aria-label="Remove ${name}" title="Remove" @click=${() => editor.removeStep(id)}>${icon('close')}</button>`;
  }
}

/** “Style: oloid”, “Cubic”: the method, and what it borrows. */
function nameOf({ method: id, parameters }: Step): string {
  const method = findMethod(id);
  const name = styleParameter(method)?.name ?? imageParameter(method);
  const borrowed = name === undefined ? undefined : parameters[name];
  const title = method?.title ?? id;
  if (typeof borrowed !== 'string') return title;
  return `${title}: ${borrowed.replace(/\.[^.]*$/, '').replaceAll('-', ' ')}`;
}

customElements.define('whittle-stack', WhittleStack);
