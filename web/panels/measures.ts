import { html, nothing, svg, type TemplateResult } from 'lit';
import { measuredOf } from '../../src/editor/measured.ts';
import { shownResult } from '../../src/editor/project.ts';
import { type LineField, linesFor, measuresFor, type Overlay } from '../../src/measures/index.ts';
import { histogram, rangeOf } from '../../src/measures/scale.ts';
import type { Page } from '../app/actions.ts';
import { ramp } from '../app/color-ramp.ts';
import type { PageState } from '../app/page-state.ts';
import { curve } from './sparkline.ts';

const width = 272;
const height = 64;
const parts = 34;

const nothingChosen = { name: 'none', label: 'Nothing' } as const;

/** Ways to look closer: colours on the mesh, how their values are spread, and how the energy fell. */
export function measures(page: Page, { look, overlay, project, activity }: PageState): TemplateResult {
  const energy =
    activity.kind === 'solving' ? activity.energy : ((project && shownResult(project)?.energy) ?? []);
  const offered = project ? measuresFor(measuredOf(project)) : [];
  const lines = project ? linesFor(measuredOf(project)) : [];
  const chosen = offered.some(({ name }) => name === look.overlay) ? look.overlay : 'none';
  return html`
    <details class="measures">
      <summary><span>Look closer</span></summary>
      <fieldset class="chips">
        <legend>Colour the mesh by</legend>
        ${[nothingChosen, ...offered].map(
          ({ name, label }) => html`
            <label><input type="radio" name="overlay" .value=${name} .checked=${chosen === name} @change=${() => page.look({ overlay: name })} /><span>${label}</span></label>`,
        )}
      </fieldset>
      ${lines.length > 0 ? drawing(page, lines) : nothing}
      ${overlay ? spread(overlay) : nothing}
      ${energy.length > 1 ? fall(energy) : nothing}
    </details>
  `;
}

function drawing(page: Page, lines: readonly LineField[]): TemplateResult {
  const chosen = page.store.state.look.lines;
  const choose = (name: string, isOn: boolean) =>
    page.look({ lines: isOn ? [...chosen, name] : chosen.filter((one) => one !== name) });
  return html`
    <fieldset class="chips">
      <legend>Draw over it</legend>
      ${lines.map(
        ({ name, label }) => html`
          <label><input type="checkbox" name="lines" .value=${name} .checked=${chosen.includes(name)} @change=${(event: Event) => choose(name, (event.target as HTMLInputElement).checked)} /><span>${label}</span></label>`,
      )}
    </fieldset>`;
}

function spread({ scale, values, verdict }: Overlay): TemplateResult {
  const counts = histogram(scale, values, parts);
  const most = Math.max(...counts, 1);
  const step = width / parts;
  const range = rangeOf(scale);
  return html`
    <figure>
      <svg viewBox="0 0 ${width} ${height}" role="img" aria-label="How many vertices have which value, ${range}">
        ${counts.map((count, part) => {
          const tall = (height - 2) * Math.sqrt(count / most);
          return svg`<rect x=${part * step + 0.5} y=${height - tall} width=${step - 1} height=${tall} rx="1.5" style="fill:${ramp(scale, (part + 0.5) / parts).getStyle()}" />`;
        })}
      </svg>
      <figcaption>Vertices by value, ${range}${verdict ? html`<br />${verdict}` : nothing}</figcaption>
    </figure>`;
}

function fall(energy: readonly number[]): TemplateResult {
  const [first, last] = [energy[0]!, energy.at(-1)!];
  return html`
    <figure>
      <svg class="energy" viewBox="0 0 84 22" preserveAspectRatio="none" role="img" aria-label="Energy over ${energy.length} iterations, from ${short(first)} to ${short(last)}">
        <polyline points=${curve(energy)} />
      </svg>
      <figcaption>Energy over ${energy.length} iterations: ${short(first)} → ${short(last)}</figcaption>
    </figure>`;
}

function short(value: number): string {
  return String(Number(value.toPrecision(3)));
}
