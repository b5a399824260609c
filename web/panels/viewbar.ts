import { html, nothing } from 'lit';
import { shownResult } from '../../src/editor/project.ts';
import type { Shading } from '../../src/viewer/viewer.ts';
import { type IconName, icon } from './icons.ts';
import { PageElement } from './page-element.ts';

const shadings: readonly { value: Shading; icon: IconName; name: string; key: string }[] = [
  { value: 'smooth', icon: 'smooth', name: 'Smooth', key: '1' },
  { value: 'flat', icon: 'flat', name: 'Flat', key: '2' },
  { value: 'wire', icon: 'wire', name: 'Wireframe', key: '3' },
];

/** How one looks at the mesh. */
export class WhittleViewbar extends PageElement {
  protected override render() {
    const { look, project } = this.state;
    const { page } = this;
    return html`
      <div class="segments" role="radiogroup" aria-label="Shading">
        ${shadings.map(
          ({ value, icon: name, name: title, key }) => html`
            <label title="${title} (${key})">
              <input type="radio" name="shading" .value=${value} .checked=${look.shading === value} @change=${() => page.look({ shading: value })} />
              ${icon(name)}<span class="hidden">${title}</span>
            </label>`,
        )}
      </div>
      <button
        type="button" class="button compare" data-act="compare" aria-pressed=${look.comparing} ?disabled=${!project || !shownResult(project)}
        title="Hold to see the original (B)" @pointerdown=${this.#hold} @pointerup=${this.#let} @pointercancel=${this.#let} @lostpointercapture=${this.#let} @contextmenu=${(event: Event) => event.preventDefault()} @click=${this.#click}
      >${icon('compare')}<span>Original</span></button>
      ${page.comparing.parameter ? this.#beside() : nothing}
      <button type="button" class="button" data-act="fit" aria-label="Fit the view" title="Fit the view (F)" @click=${() => page.fit()}>${icon('fit')}</button>
      <button type="button" class="button" data-act="picture" aria-label="Save a picture" title="Save a picture (P)" @click=${() => void page.saveSnapshot()}>${icon('camera')}</button>
    `;
  }

  #beside() {
    const { comparing } = this.page;
    const title = `Compare “${comparing.parameter!.label}” side by side`;
    return html`<button type="button" class="button" data-act="beside" aria-pressed=${comparing.isOn} aria-label=${title} title="${title} (N)" @click=${() => comparing.toggle()}>${icon('beside')}</button>`;
  }

  readonly #hold = (event: PointerEvent): void => {
    (event.currentTarget as HTMLElement).setPointerCapture(event.pointerId);
    this.page.look({ comparing: true });
  };

  readonly #let = (): void => {
    if (this.state.look.comparing) this.page.look({ comparing: false });
  };

  /** From the keyboard or a screen reader there is nothing to hold: it switches. */
  readonly #click = (event: MouseEvent): void => {
    if (event.detail === 0) this.page.look({ comparing: !this.state.look.comparing });
  };
}

customElements.define('whittle-viewbar', WhittleViewbar);
