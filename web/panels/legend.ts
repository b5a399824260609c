import { html, nothing } from 'lit';
import { ticksOf } from '../../src/measures/scale.ts';
import { blank as blankColor, gradient } from '../app/color-ramp.ts';
import { PageElement } from './page-element.ts';

/** What the colours on the mesh mean. */
export class WhittleLegend extends PageElement {
  protected override render() {
    const { overlay } = this.state;
    if (!overlay) return nothing;
    const { title, summary, scale, blank } = overlay;
    return html`
      <div class="legend">
        <p><b>${title}</b><span>${summary}</span></p>
        <div class="band" style="background:${gradient(scale)}"></div>
        <p class="ends">${ticksOf(scale).map((tick) => html`<span class="tick">${tick}</span>`)}</p>
        ${blank ? html`<p class="blank"><span><i style="background:${blankColor.getStyle()}"></i>${blank}: no value</span></p>` : nothing}
      </div>`;
  }
}

customElements.define('whittle-legend', WhittleLegend);
