import { html, nothing } from 'lit';
import { live } from 'lit/directives/live.js';
import type { ToolFace } from '../app/tool-belt.ts';
import type { ToolId } from '../tools/tool.ts';
import { icon } from './icons.ts';
import { PageElement } from './page-element.ts';

/** The tools, and the options of the one that is in the hand. */
export class WhittleToolStrip extends PageElement {
  protected override render() {
    const { faces } = this.page.tools;
    if (faces.length < 2 || !this.state.project) return nothing;
    return html`
      <div class="strip" role="radiogroup" aria-label="Tools" aria-busy=${this.page.tools.isBusy}>${faces.map((face) => this.#face(face))}</div>
    `;
  }

  #face({ id, title, key, does }: ToolFace) {
    return html`
      <label title="${title} (${key.toUpperCase()}): ${does}">
        <input type="radio" name="tool" .value=${id} .checked=${live(this.state.tool === id)} @change=${this.#choose} />
        ${icon(id)}<span>${title}</span>
      </label>`;
  }

  readonly #choose = (event: Event): void => {
    this.page.tools.choose((event.target as HTMLInputElement).value as ToolId);
  };
}

customElements.define('whittle-tool-strip', WhittleToolStrip);
