import { html, nothing, type TemplateResult } from 'lit';
import type { MethodDescriptor } from '../../src/methods/descriptor.ts';
import { methodsByIntent } from '../app/offered-methods.ts';
import { shortcuts } from '../app/shortcuts.ts';
import { icon } from './icons.ts';
import { hide, methodPicture } from './method-picker.ts';
import { PageElement } from './page-element.ts';

/** What this is, what the methods and tools do, and which keys there are. Opens on the event `open`. */
export class WhittleHelp extends PageElement {
  constructor() {
    super();
    this.addEventListener('open', () => this.querySelector('dialog')?.showModal());
  }

  protected override render() {
    return html`
      <dialog class="help" aria-labelledby="help-title" @click=${this.#outside}>
        <header>
          <h2 id="help-title">Whittle</h2>
          <form method="dialog"><button class="button bare" aria-label="Close">${icon('close')}</button></form>
        </header>
        <p>
          Drop a mesh anywhere, choose what to do to it, and take the same file home with only its positions changed.
          Nothing leaves your computer: all of it runs in this page, which keeps your work until you come back.
        </p>
        ${methodsByIntent().map(
          ({ title, methods }) => html`
            <h3>${title}</h3>
            <ul class="help-methods">${methods.map(this.#method)}</ul>`,
        )}
        ${this.#tools()}
        <h3>Keys</h3>
        <dl>
          ${shortcuts.map(({ label, does }) => keys(html`<kbd>${label}</kbd>`, does))}
          ${keys(html`<kbd>Ctrl</kbd> <kbd>Z</kbd>`, 'Undo; with Shift redo')}
          ${keys(html`<kbd>Esc</kbd>`, 'Stop and keep the shape')}
          ${keys(html`<kbd>?</kbd>`, 'This help')}
        </dl>
      </dialog>
    `;
  }

  readonly #method = (method: MethodDescriptor) => html`
    <li>
      <img src=${methodPicture(method)} alt="" width="46" height="46" loading="lazy" @error=${hide} />
      <p><b>${method.title}</b> ${method.summary}</p>
    </li>`;

  #tools() {
    const { faces } = this.page.tools;
    if (faces.length < 2) return nothing;
    return html`
      <h3>Tools</h3>
      <dl class="help-tools">${faces.map(({ title, key, does }) => keys(html`<kbd>${key.toUpperCase()}</kbd>`, html`<b>${title}</b> ${does}`))}</dl>
      <p>With Turn, drag to turn the view, scroll or pinch to come closer, drag with the right button or two fingers to move it.</p>`;
  }

  readonly #outside = (event: MouseEvent): void => {
    const dialog = event.currentTarget as HTMLDialogElement;
    if (event.target === dialog) dialog.close();
  };
}

function keys(face: TemplateResult, does: TemplateResult | string) {
  return html`<div><dt>${face}</dt><dd>${does}</dd></div>`;
}

customElements.define('whittle-help', WhittleHelp);
