import { html, nothing } from 'lit';
import { icon } from './icons.ts';
import { PageElement } from './page-element.ts';

/** A sentence that a person can act on. It stays until it is dismissed and never stands in the way. */
export class WhittleNotice extends PageElement {
  protected override render() {
    const { notice } = this.state;
    const tone = notice?.tone ?? 'note';
    return html`
      <div role="alert">${notice?.tone === 'error' ? this.#card(tone) : nothing}</div>
      <div role="status">${notice?.tone === 'note' ? this.#card(tone) : nothing}</div>
    `;
  }

  #card(tone: string) {
    const { text, action } = this.state.notice!;
    return html`
      <div class="notice" data-tone=${tone}>
        <p>${text}</p>
        ${action ? html`<button type="button" class="button small" data-act="again" @click=${() => action.run()}>${action.label}</button>` : nothing}
        <button type="button" class="button bare" data-act="dismiss" aria-label="Dismiss" @click=${() => this.page.dismiss()}>${icon('close')}</button>
      </div>`;
  }
}

customElements.define('whittle-notice', WhittleNotice);
