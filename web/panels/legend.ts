import { html, nothing } from 'lit';
import { rampGradient } from '../document/ramp.ts';
import { PageElement } from './page-element.ts';

/** What the colours on the mesh mean. */
export class WhittleLegend extends PageElement {
  protected override render() {
    const { overlay } = this.state;
    if (!overlay) return nothing;
    const { title, unit, max, mean } = overlay;
    return html`
      <div class="legend">
        <p><b>${title}</b><span>on average ${mean.toPrecision(3)}${unit}</span></p>
        <div class="band" style="background:${rampGradient}"></div>
        <p class="ends"><span>0</span><span>${max}${unit}</span></p>
      </div>`;
  }
}

customElements.define('whittle-legend', WhittleLegend);
