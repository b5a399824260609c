import { html, nothing } from 'lit';
import { live } from 'lit/directives/live.js';
import { styleMap } from 'lit/directives/style-map.js';
import type { Picture } from '../../src/editor/comparison.ts';
import type { Box } from '../../src/viewer/box.ts';
import { icon } from './icons.ts';
import { PageElement } from './page-element.ts';

/** What stands on each of several pictures side by side: which choice it shows, and the way to take it. */
export class WhittleComparison extends PageElement {
  protected override render() {
    const { comparing } = this.page;
    const { frames, compared } = this.state;
    if (!comparing.isOn || frames.length < 2) return nothing;
    const [first, ...others] = frames;
    return html`
      ${this.#frame(first!, comparing.own, (value) => comparing.choose(value), html`<span class="in-use">in use</span>${this.#more()}`, true)}
      ${others.map((frame, k) =>
        this.#frame(
          frame,
          compared[k]!,
          (value) => comparing.change(k, value),
          this.#acts(k, comparing.pictures[k]),
        ),
      )}
    `;
  }

  #frame(
    { left, top, width, height }: Box,
    value: string,
    change: (value: string) => void,
    acts: unknown,
    isOwn = false,
  ) {
    const place = {
      left: `${left}px`,
      top: `${top}px`,
      width: `${width}px`,
      height: `${height}px`,
    };
    const { label, choices } = this.page.comparing.parameter!;
    const chosen = (event: Event) => change((event.target as HTMLSelectElement).value);
    return html`
      <section class="compared" ?data-own=${isOwn} style=${styleMap(place)} aria-label=${this.#nameOf(value)}>
        <div class="compared-bar">
          <select aria-label=${label} .value=${live(value)} @change=${chosen}>
            ${choices.map((choice) => html`<option value=${choice} ?selected=${choice === value}>${this.#nameOf(choice)}</option>`)}
          </select>
          ${acts}
        </div>
      </section>`;
  }

  /** Another picture, where there is room. */
  #more() {
    const { comparing } = this.page;
    return this.state.compared.length + 1 < comparing.most
      ? html`<button type="button" class="button bare" data-act="compare-more" aria-label="Compare one more" title="Compare one more" @click=${() => comparing.add()}>${icon('add')}</button>`
      : nothing;
  }

  #acts(picture: number, { isRunning = false, failure = null }: Partial<Picture> = {}) {
    const { comparing } = this.page;
    const name = this.#nameOf(this.state.compared[picture]!);
    return html`
      ${isRunning ? html`<span class="pulse" aria-hidden="true"></span>` : nothing}
      <button type="button" class="button small" data-act="adopt" aria-label="Use ${name}" title="Use it (or click the picture)" @click=${() => comparing.adopt(picture)}>Use</button>
      <button type="button" class="button bare" data-act="compare-less" aria-label="Take ${name} away" title="Take it away" @click=${() => comparing.remove(picture)}>${icon('close')}</button>
      ${failure ? html`<p class="failure" role="status">${failure}</p>` : nothing}`;
  }

  #nameOf(value: string): string {
    return this.page.comparing.parameter?.labels?.[value] ?? value;
  }
}

customElements.define('whittle-comparison', WhittleComparison);
