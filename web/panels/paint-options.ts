import { html, nothing } from 'lit';
import type { Page } from '../app/actions.ts';
import { strengthGradient } from '../app/color-ramp.ts';
import type { PaintMode, PaintOptions, PaintStrength } from '../tools/paint-strength.ts';
import './strength-ball.ts';

const modes: readonly { id: PaintMode; title: string; does: string }[] = [
  {
    id: 'subtract',
    title: 'Less',
    does: 'Paint where the style is to be weaker, on the mesh or on the ball.',
  },
  { id: 'add', title: 'More', does: 'Paint where the style is to be stronger again.' },
  { id: 'set', title: 'Set', does: 'Paint a strength of your choice.' },
  { id: 'smooth', title: 'Soften', does: 'Paint over a border to make it soft.' },
  { id: 'erase', title: 'Erase', does: 'Paint back to full strength, as if nobody had painted.' },
  { id: 'pick', title: 'Pick', does: 'Press to take the strength from there, then paint with it.' },
];

/** The brush for strength, and the ball. */
export function paintOptions(page: Page, tool: PaintStrength) {
  const { strength } = page;
  if (!strength.isOnSurface) return unable();
  const { mode, mirror } = tool.options;
  const { does } = modes.find(({ id }) => id === mode)!;
  return html`
    <h2>Paint strength</h2>
    <p class="does">${mode === 'add' && !strength.shares && !strength.field ? fullAlready : does}</p>
    <div class="row modes" role="group" aria-label="What the brush does">
      ${modes.map(
        ({ id, title, does: hint }) =>
          html`<button type="button" class="button small" data-mode=${id} aria-pressed=${mode === id} title=${hint} @click=${() => tool.set({ mode: id })}>${title}</button>`,
      )}
    </div>
    ${mode === 'set' ? slider(tool, 'value', 'Strength', 0, 1) : nothing}
    <div class="row fills">
      <button type="button" class="button small" data-act="strong-everywhere" ?disabled=${!strength.shares} @click=${() => tool.fill('shares', 1)}>Everywhere</button>
      <button type="button" class="button small" data-act="strong-nowhere" @click=${() => tool.fill('shares', 0)}>Nowhere</button>
    </div>
    <div class="strength-legend" aria-hidden="true"><span>none</span><i style="background: ${strengthGradient}"></i><span>full</span></div>
    <div class="folds">
    <details>
      <summary>Brush</summary>
      ${slider(tool, 'size', 'Size', 0.01, 0.3)}
      ${slider(tool, 'strength', 'Force', 0.05, 1)}
      ${slider(tool, 'hardness', 'Hardness', 0, 1)}
      <label class="field" title="What is painted on the left is painted on the right"><span>Mirror</span>
        <input type="checkbox" .checked=${mirror} @change=${(event: Event) => tool.set({ mirror: (event.target as HTMLInputElement).checked })} /></label>
    </details>
    ${strength.isOnBall ? ball(page, tool) : nothing}
    </div>
  `;
}

/** On a phone the mesh needs the room. */
const isWide = () => matchMedia('(min-width: 761px)').matches;

const fullAlready =
  'All of it has full strength already. Press Nowhere first, or paint where it is to be less.';

function ball(page: Page, tool: PaintStrength) {
  const { strength } = page;
  return html`
    <details ?open=${isWide()}>
      <summary>By direction</summary>
      <p>Paint the ball’s top, and whatever looks up follows.</p>
      <whittle-strength-ball .page=${page} .tool=${tool}></whittle-strength-ball>
      <div class="row ball-acts">
        <button type="button" class="button small" data-act="strong-all-ways" ?disabled=${!strength.field} @click=${() => tool.fill('field', 1)}>All</button>
        <button type="button" class="button small" data-act="strong-no-way" @click=${() => tool.fill('field', 0)}>None</button>
        <button type="button" class="button small" data-act="save-ball" ?disabled=${!strength.field} title="Save the ball as a picture" @click=${() => strength.saveBall()}>Save</button>
        <button type="button" class="button small" data-act="load-ball" title="Load a grey picture of the ball" @click=${choosePicture}>Load</button>
        <input type="file" accept=".png" hidden aria-label="Picture of the ball" @change=${(event: Event) => takePicture(event, page)} />
      </div>
    </details>`;
}

function unable() {
  return html`
    <h2>Paint strength</h2>
    <p>This step has no strength to paint. Choose or add one that carves, such as Cubic.</p>`;
}

function slider(
  tool: PaintStrength,
  name: 'size' | 'strength' | 'hardness' | 'value',
  label: string,
  min: number,
  max: number,
) {
  const value = tool.options[name];
  const set = (event: Event) => {
    const change: Partial<PaintOptions> = { [name]: (event.target as HTMLInputElement).valueAsNumber };
    tool.set(change);
  };
  return html`
    <label class="field brush"><span>${label}</span>
      <input type="range" class="plain" data-brush=${name} min=${min} max=${max} step="0.01" .value=${String(value)} aria-valuetext="${Math.round(100 * value)} percent" @input=${set} /></label>`;
}

function choosePicture(event: Event): void {
  ((event.currentTarget as HTMLElement).nextElementSibling as HTMLInputElement).click();
}

function takePicture(event: Event, page: Page): void {
  const input = event.target as HTMLInputElement;
  const [file] = input.files ?? [];
  input.value = '';
  if (file) void page.strength.loadBall(file);
}
