import { html, nothing, svg, type TemplateResult } from 'lit';
import { histogram, ramp } from '../document/ramp.ts';
import type { OverlayName, State } from '../document/store.ts';
import type { Page } from '../tools/page.ts';
import { curve } from './sparkline.ts';

const width = 272;
const height = 64;
const parts = 34;

const choices: readonly { readonly name: OverlayName; readonly label: string }[] = [
  { name: 'none', label: 'Nothing' },
  { name: 'before', label: 'Angle before' },
  { name: 'after', label: 'Angle after' },
  { name: 'moved', label: 'Movement' },
];

/** Ways to look closer: colours on the mesh, how their values are spread, and how the energy fell. */
export function measures(page: Page, { look, overlay, document, activity }: State): TemplateResult {
  const energy = activity.kind === 'solving' ? activity.energy : (document?.result?.energy ?? []);
  return html`
    <details class="measures">
      <summary><span>Look closer</span></summary>
      <fieldset class="chips">
        <legend>Colour the mesh by</legend>
        ${choices.map(
          ({ name, label }) => html`
            <label><input type="radio" name="overlay" .value=${name} .checked=${look.overlay === name} @change=${() => page.look({ overlay: name })} /><span>${label}</span></label>`,
        )}
      </fieldset>
      ${overlay ? spread(histogram(overlay.values, overlay.max, parts), `0 to ${overlay.max}${overlay.unit}`) : nothing}
      ${energy.length > 1 ? fall(energy) : nothing}
    </details>
  `;
}

function spread(counts: readonly number[], range: string): TemplateResult {
  const most = Math.max(...counts, 1);
  const step = width / counts.length;
  return html`
    <figure>
      <svg viewBox="0 0 ${width} ${height}" role="img" aria-label="How many vertices have which value, ${range}">
        ${counts.map((count, part) => {
          const tall = (height - 2) * Math.sqrt(count / most);
          return svg`<rect x=${part * step + 0.5} y=${height - tall} width=${step - 1} height=${tall} rx="1.5" style="fill:${ramp((part + 0.5) / counts.length).getStyle()}" />`;
        })}
      </svg>
      <figcaption>Vertices by value, ${range}</figcaption>
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
