import { html, nothing } from 'lit';
import { live } from 'lit/directives/live.js';
import { activeStep } from '../../src/editor/project.ts';
import type { MethodDescriptor } from '../../src/methods/descriptor.ts';
import { findMethod } from '../../src/methods/registry.ts';
import { methodsByIntent, obstacle, offeredMethods } from '../app/offered-methods.ts';
import { PageElement } from './page-element.ts';

/** What can be done to a mesh, as pictures, by what a person wants; and what the chosen one does, in a sentence. */
export class WhittleMethodPicker extends PageElement {
  protected override render() {
    const { project } = this.state;
    const chosen = (project && findMethod(activeStep(project).method)) ?? offeredMethods()[0];
    return html`
      <fieldset class="switch">
        <legend class="hidden">What to do</legend>
        ${methodsByIntent().map(
          ({ title, methods }) => html`
            <div class="intent" role="group" aria-label=${title} style="--tiles: ${methods.length}">
              <p class="group-title" aria-hidden="true">${title}</p>
              <div class="intent-tiles">${methods.map((method) => this.#tile(method, method === chosen))}</div>
            </div>`,
        )}
      </fieldset>
      <p class="summary" title=${chosen?.paper ?? nothing}>${chosen?.summary}</p>
    `;
  }

  /** A method that this mesh is not made for can be asked why. */
  #tile(method: MethodDescriptor, isChosen: boolean) {
    const { project } = this.state;
    const why = project ? obstacle(method, project.mesh) : undefined;
    return html`
      <label title=${why ?? method.summary}>
        <input type="radio" name="method" .value=${method.id} .checked=${live(isChosen)} ?data-obstacle=${why !== undefined} @change=${this.#choose} /><span class="switch-face"><img src=${methodPicture(method)} alt="" width="46" height="46" @error=${hide} />${method.title}</span>
      </label>`;
  }

  readonly #choose = (event: Event): void => {
    this.page.chooseMethod((event.target as HTMLInputElement).value);
    this.requestUpdate(); // it may have stayed with what it was
  };
}

/** Where the little picture of what a method does lies. */
export function methodPicture({ id }: MethodDescriptor): string {
  return `${import.meta.env.BASE_URL}thumbnails/methods/${id}.webp`;
}

/** A method without a picture has its name. */
export function hide({ target }: Event): void {
  (target as HTMLElement).style.visibility = 'hidden';
}

customElements.define('whittle-method-picker', WhittleMethodPicker);
