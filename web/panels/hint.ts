import { html, nothing } from 'lit';
import { Hints } from '../app/hints.ts';
import type { PageState } from '../app/page-state.ts';
import { PageElement } from './page-element.ts';

/** One line for who takes a tool for the first time. It goes for good once something was done with the tool, or at a word. */
export class WhittleHint extends PageElement {
  readonly #hints = new Hints();
  /** How many entries undo had when the tool was taken. */
  #entries = 0;
  #tool: PageState['tool'] | null = null;

  protected override stateChanged({ tool, history: { past } }: PageState): void {
    if (tool === this.#tool && past.length > this.#entries) this.#hints.learn(tool);
    this.#tool = tool;
    this.dataset.tool = tool;
    this.#entries = past.length;
  }

  protected override render() {
    const { tool, project } = this.state;
    const text = project ? this.#hints.textFor(tool) : null;
    if (text === null) return nothing;
    return html`
      <div class="hint" role="note">
        <p>${text}</p>
        <button type="button" class="button small" data-act="got-it" @click=${this.#dismiss}>Got it</button>
      </div>`;
  }

  readonly #dismiss = (): void => {
    this.#hints.learn(this.state.tool);
    this.requestUpdate();
  };
}

customElements.define('whittle-hint', WhittleHint);
