import { html, nothing } from 'lit';
import { measuredOf } from '../../src/editor/measured.ts';
import { type LineField, linesFor, type Overlay } from '../../src/measures/index.ts';
import { ticksOf } from '../../src/measures/scale.ts';
import { blank as blankColor, gradient } from '../app/color-ramp.ts';
import { lineColor } from '../app/line-paint.ts';
import { PageElement } from './page-element.ts';

/** What the colours on the mesh mean. */
export class WhittleLegend extends PageElement {
  protected override render() {
    const { overlay, lines } = this.state;
    if (!overlay && lines.length === 0) return nothing;
    return html`<div class="legend">${overlay ? this.#colors(overlay) : nothing}${lines.map((one) => this.#line(one))}</div>`;
  }

  #line({ name, label, values }: LineField) {
    const { project } = this.state;
    const all = project ? linesFor(measuredOf(project)) : [];
    const count = values.length / 2;
    return html`<p class="line"><span><i style="background:${lineColor(all, name)}"></i>${label}</span><span>${count} ${count === 1 ? 'edge' : 'edges'}</span></p>`;
  }

  #colors(overlay: Overlay) {
    const { title, summary, scale, blank } = overlay;
    return html`
        <p><b>${title}</b><span>${summary}</span></p>
        <div class="band" style="background:${gradient(scale)}"></div>
        <p class="ends">${ticksOf(scale).map((tick) => html`<span class="tick">${tick}</span>`)}</p>
        ${blank ? html`<p class="blank"><span><i style="background:${blankColor.getStyle()}"></i>${blank}: no value</span></p>` : nothing}`;
  }
}

customElements.define('whittle-legend', WhittleLegend);
