import { html, nothing } from 'lit';
import { repeat } from 'lit/directives/repeat.js';
import type { Step } from '../../src/editor/project.ts';
import { imageParameter, styleParameter } from '../../src/editor/starting-step.ts';
import { findMethod } from '../../src/methods/registry.ts';
import { obstacle, offeredMethods } from '../app/offered-methods.ts';
import { icon } from './icons.ts';
import { PageElement } from './page-element.ts';
import './menu.ts';

/**
 * The steps, first to last: each works on what the one before left. A click goes back into a step, its box switches it off, its
 * arrows move it. Of a single step nothing is shown but the way to a second.
 */
export class WhittleStack extends PageElement {
  protected override render() {
    const { project } = this.state;
    if (!project) return nothing;
    const { steps } = project;
    return html`
      ${
        steps.length > 1
          ? html`<ol class="stack" aria-label="Steps">${repeat(
              steps,
              ({ id }) => id,
              (step, place) => this.#row(step, place),
            )}</ol>`
          : nothing
      }
      <whittle-menu label="Add a step" .face=${html`${icon('add')}<span>Add a step</span>`} .items=${this.#additions()}></whittle-menu>
    `;
  }

  #row(step: Step, place: number) {
    const { steps, active } = this.state.project!;
    const { activity } = this.state;
    const name = nameOf(step);
    const isBusy = activity.kind === 'solving' && activity.step === step.id;
    const { editor } = this.page;
    return html`
      <li data-step=${place + 1} ?data-active=${step.id === active} ?data-busy=${isBusy} ?data-off=${!step.isOn}>
        <input type="checkbox" .checked=${step.isOn} aria-label="${name} is on" title=${step.isOn ? 'Switch it off' : 'Switch it on'} @change=${() => editor.switchStep(step.id, !step.isOn)} />
        <button type="button" class="step-name" aria-current=${step.id === active ? 'step' : nothing} @click=${() => editor.activate(step.id)}><span class="place">${place + 1}</span>${name}</button>
        <button type="button" class="button bare small" data-act="step-up" ?disabled=${place === 0} aria-label="Move ${name} up" title="Earlier" @click=${() => editor.moveStep(step.id, place - 1)}>${icon('up')}</button>
        <button type="button" class="button bare small" data-act="step-down" ?disabled=${place === steps.length - 1} aria-label="Move ${name} down" title="Later" @click=${() => editor.moveStep(step.id, place + 1)}>${icon('down')}</button>
        <button type="button" class="button bare small" data-act="step-remove" aria-label="Remove ${name}" title="Remove" @click=${() => editor.removeStep(step.id)}>${icon('close')}</button>
      </li>`;
  }

  #additions() {
    const { mesh } = this.state.project!;
    return offeredMethods()
      .filter((method) => obstacle(method, mesh) === undefined)
      .map(({ id, title, summary }) => ({
        label: title,
        about: summary,
        run: () => void this.page.styles.addStep(id),
      }));
  }
}

/** “Style: oloid”, “Cubic”: the method, and what it borrows. */
function nameOf({ method: id, parameters }: Step): string {
  const method = findMethod(id);
  const name = styleParameter(method)?.name ?? imageParameter(method);
  const borrowed = name === undefined ? undefined : parameters[name];
  const title = method?.title ?? id;
  return typeof borrowed === 'string'
    ? `${title}: ${borrowed.replace(/\.[^.]*$/, '').replaceAll('-', ' ')}`
    : title;
}

customElements.define('whittle-stack', WhittleStack);
