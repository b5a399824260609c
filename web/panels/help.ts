import { html } from 'lit';
import { shortcuts } from '../app/shortcuts.ts';
import { icon } from './icons.ts';
import { PageElement } from './page-element.ts';

/** What this is and which keys there are. Opens on the event `open`. */
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
          Drop a mesh anywhere, drag the slider, take the same file home with only its positions changed.
          Nothing leaves your computer: all of it runs in this page.
        </p>
        <p>Drag to turn, scroll or pinch to come closer, drag with the right button or two fingers to move.</p>
        <dl>
          ${shortcuts.map(({ label, does }) => html`<div><dt><kbd>${label}</kbd></dt><dd>${does}</dd></div>`)}
          <div><dt><kbd>Ctrl</kbd> <kbd>Z</kbd></dt><dd>Undo; with Shift redo</dd></div>
          <div><dt><kbd>Esc</kbd></dt><dd>Stop and keep the shape</dd></div>
          <div><dt><kbd>?</kbd></dt><dd>This list</dd></div>
        </dl>
      </dialog>
    `;
  }

  readonly #outside = (event: MouseEvent): void => {
    const dialog = event.currentTarget as HTMLDialogElement;
    if (event.target === dialog) dialog.close();
  };
}

customElements.define('whittle-help', WhittleHelp);
