import { html, nothing } from 'lit';
import { activeStep, type StepInputs, shownResult } from '../../src/editor/project.ts';
import { findMethod } from '../../src/methods/registry.ts';
import { isUnheld } from '../../src/methods/set-by-hand.ts';
import type { PageState } from '../app/page-state.ts';
import { PageElement } from './page-element.ts';
import { sparkline } from './sparkline.ts';

/** One line about what is happening, with a way to stop it. */
export class WhittleStatus extends PageElement {
  #spoken = '';

  protected override stateChanged(state: PageState): void {
    const { activity } = state;
    this.dataset.activity = activity.kind;
    this.#spoken = activity.kind === 'solving' ? working(state.project) : sentence(state);
  }

  protected override render() {
    const { activity, project } = this.state;
    const busy = activity.kind !== 'idle';
    const energy =
      activity.kind === 'solving' ? activity.energy : ((project && shownResult(project)?.energy) ?? []);
    return html`
      <span class="pulse" aria-hidden="true"></span>
      <span class="sentence" aria-hidden="true">${sentence(this.state)}</span>
      ${energy.length > 1 ? html`<span title="Energy">${sparkline(energy)}</span>` : nothing}
      ${busy ? html`<button type="button" class="button small" data-act="cancel" title="Stop and keep what there is (Esc)" @click=${() => this.page.editor.cancel()}>Cancel</button>` : nothing}
      <span class="hidden" role="status">${this.#spoken}</span>
    `;
  }
}

function sentence({ activity, project }: PageState): string {
  switch (activity.kind) {
    case 'opening':
      return `Opening ${activity.name}…`;
    case 'writing':
      return `Writing ${activity.name}…`;
    case 'solving':
      if (activity.preparing)
        return `${capital(activity.preparing.stage)}… ${Math.round(100 * activity.preparing.share)} %`;
      return `${activity.live ? working(project) : 'Settling'}…${activity.iteration > 0 ? ` iteration ${activity.iteration}` : ''}`;
    default:
      return rest(project);
  }
}

function rest(project: PageState['project']): string {
  const result = project && shownResult(project);
  if (!result) return 'As it came';
  if (isUnheld(findMethod(result.of.method), result.of.parameters)) return 'Nothing is held or pulled yet';
  const many = `${result.iterations} ${result.iterations === 1 ? 'iteration' : 'iterations'}`;
  if (result.state === 'stopped') return `Stopped after ${many}; this shape is kept`;
  if (result.outcome === 'iteration-limit' && !endsByCount(result.of.method))
    return `Stopped at the limit of ${many}`;
  const seconds = result.milliseconds / 1000;
  const done = isByHand(result.of) ? 'Shaped' : 'Carved';
  return `${done} in ${many}, ${seconds < 10 ? seconds.toFixed(2) : seconds.toFixed(0)} s`;
}

/** What a run does, in a word. */
function working(project: PageState['project']): string {
  return project && isByHand(activeStep(project)) ? 'Shaping' : 'Carving';
}

/** Whether it is a person who says where the shape goes. */
function isByHand({ method }: Pick<StepInputs, 'method'>): boolean {
  return findMethod(method)?.intent === 'move';
}

/** Whether nothing but the number of iterations ends the method: without a tolerance it is no limit but all there is. */
function endsByCount(method: string): boolean {
  return !findMethod(method)?.parameters.some(({ name }) => name === 'tolerance');
}

function capital(text: string): string {
  return text.charAt(0).toUpperCase() + text.slice(1);
}

customElements.define('whittle-status', WhittleStatus);
