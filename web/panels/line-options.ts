import { html, nothing } from 'lit';
import type { ChainRole, ChainsParameter } from '../../src/methods/values/chains.ts';
import type { Page } from '../app/actions.ts';
import { lineColors, plainColor } from '../tools/line-layers.ts';
import type { MarkLines } from '../tools/mark-lines.ts';
import { icon } from './icons.ts';

const titles: Readonly<Record<ChainRole, string>> = {
  crease: 'Crease',
  smooth: 'Smooth',
  straight: 'Straight',
};

/** What lines along edges are marked as, and which are. */
export function lineOptions(page: Page, tool: MarkLines) {
  const { parameter } = tool;
  const { parameters } = page.lines;
  if (!parameter) {
    return html`
      <h2>Mark lines</h2>
      <p>This step goes by no lines. Another way to reshape does.</p>`;
  }
  return html`
    <h2>Mark lines</h2>
    <p>Click an edge to mark all of its line, and again to take the mark away. Dragging marks what it meets.</p>
    <div class="row" role="group" aria-label="What lines are marked as">
      ${parameters.map(
        ({ role, hint, doc }) =>
          html`<button type="button" class="button small marks" data-role=${role} style="--dot: ${lineColors[role]}" aria-pressed=${role === parameter.role} title=${hint ?? doc} @click=${() => tool.choose(role)}>${titles[role]}</button>`,
      )}
    </div>
    <p class="explained">${parameter.hint ?? parameter.doc}</p>
    <p class="explained found"><i aria-hidden="true" style="--dot: ${plainColor}"></i>Creases of the shape itself${page.lines.angle === undefined ? nothing : html`, from a bend of ${page.lines.angle}° on`}</p>
    <p class="pointed" aria-live="polite">${tool.pointed ?? nothing}</p>
    <ul class="groups" aria-label="Marked lines">
      ${parameters.filter((one) => page.lines.of(one).length > 0).map((one) => marked(page, one))}
    </ul>`;
}

function marked({ lines }: Page, parameter: ChainsParameter) {
  const count = lines.of(parameter).length;
  const said = `${count} ${count === 1 ? 'line' : 'lines'}`;
  return html`
    <li style="--dot: ${lineColors[parameter.role]}">
      <span class="marked-lines">${parameter.label}: ${said}</span>
      <button type="button" class="step-act" data-clear=${parameter.role} aria-label="Unmark all: ${parameter.label}" title="Take these marks away" @click=${() => lines.clear(parameter)}>${icon('close')}</button>
    </li>`;
}
