import { html } from 'lit';
import type { Vec3 } from '../../src/mesh/vectors.ts';
import { normalColor, PaintBall } from '../../src/viewer/paint-ball.ts';
import { darkTheme, lightTheme } from '../../src/viewer/stage.ts';
import { nudged, toFile, toSeen } from '../app/view-directions.ts';
import type { NormalBrushMode } from '../tools/paint-normals.ts';
import { icon } from './icons.ts';
import { PageElement } from './page-element.ts';
import './direction.ts';

const step = Math.PI / 24;
const walks: Readonly<Record<string, readonly [number, number]>> = {
  ArrowRight: [step, 0],
  ArrowLeft: [-step, 0],
  ArrowUp: [0, step],
  ArrowDown: [0, -step],
};

const brushModes: readonly { id: NormalBrushMode; title: string; does: string }[] = [
  { id: 'paint', title: 'Paint', does: 'What looks this way turns to the way of the arrow' },
  { id: 'erase', title: 'Erase', does: 'What looks this way stays as it is' },
  { id: 'pick', title: 'Pick', does: 'Take the direction that is painted there' },
];

/** The ball that is painted on, its brush, and what can be done with the picture. */
export class WhittlePainter extends PageElement {
  #ball: PaintBall | null = null;
  /** Where the brush is, on the ball. */
  #at: Vec3 | null = null;
  #unwatch: (() => void) | null = null;
  /** What the ball's picture was made of. */
  #shown: readonly unknown[] | null = null;

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.#unwatch?.();
    this.#ball?.dispose();
    this.#unwatch = this.#ball = this.#shown = null;
  }

  protected override render() {
    const { painter } = this.page;
    const { mode, size, hardness, direction, mirror } = painter.brush;
    return html`
      <p class="painter-words">The ball is every way a surface can look. Where you paint, surfaces turn to the way of the arrow.</p>
      <div class="painter-balls">
        <canvas
          class="ball" tabindex="0" role="application" aria-label="The ball to paint on. Arrow keys move the brush, Space paints."
          @pointerdown=${this.#down} @pointermove=${this.#move} @pointerup=${this.#up} @pointercancel=${this.#up}
          @pointerleave=${this.#leave} @keydown=${this.#key} @blur=${this.#leave}
        ></canvas>
        <whittle-direction
          .seen=${toSeen(direction, this.page.view)} .color=${normalColor(direction).getStyle()}
          @direction=${({ detail }: CustomEvent<Vec3>) => painter.setBrush({ direction: toFile(detail, this.page.view) })}
        ></whittle-direction>
      </div>
      <div class="painter-tools" role="group" aria-label="What the brush does">
        ${brushModes.map(
          ({ id, title, does }) =>
            html`<button type="button" class="button small" data-brush=${id} aria-pressed=${mode === id} title=${does} @click=${() => painter.setBrush({ mode: id })}>${title}</button>`,
        )}
      </div>
      <label class="field"><span>Size</span>
        <input type="range" class="plain" min="6" max="80" step="1" .value=${String(size)} aria-valuetext="${size} degrees" @input=${(event: Event) => painter.setBrush({ size: sliderValue(event) })} /></label>
      <label class="field"><span>Hardness</span>
        <input type="range" class="plain" min="0" max="1" step="0.05" .value=${String(hardness)} aria-valuetext="${Math.round(100 * hardness)} percent" @input=${(event: Event) => painter.setBrush({ hardness: sliderValue(event) })} /></label>
      <label class="field" title="Paint the mirror image on the far side too"><span>Mirror to the back</span>
        <input type="checkbox" .checked=${mirror} @change=${(event: Event) => painter.setBrush({ mirror: (event.target as HTMLInputElement).checked })} /></label>
      <div class="painter-tools">
        <button type="button" class="button small" data-act="clear-ball" title="An empty ball: every normal stays" @click=${() => painter.clear()}>${icon('reset')}Clear</button>
        <button type="button" class="button small" data-act="save-capture" title="Save the ball as a PNG" @click=${() => this.page.saveCapture()}>${icon('export')}Save</button>
        <button type="button" class="button small" data-act="load-capture" title="Load a PNG of a ball that holds normals" @click=${() => this.page.pickStyle('.png')}>${icon('open')}Load</button>
      </div>
    `;
  }

  protected override updated(): void {
    this.#ball ??= this.#open();
    if (!this.#ball) return;
    const { normals } = this.page.painter.map;
    const { theme = 'light' } = document.documentElement.dataset;
    const { x, y, z, w } = this.page.view.orientation;
    const now = [normals, theme, x, y, z, w, this.#at, this.page.painter.brush.size] as const;
    // Every frame of a run comes by here; most change nothing on the ball.
    if (this.#shown?.every((value, k) => value === now[k])) return;
    if (this.#shown?.[1] !== theme) this.#ball.setTheme(theme === 'dark' ? darkTheme : lightTheme);
    if (this.#shown?.[0] !== normals || this.#shown[1] !== theme) this.#ball.setNormals(normals);
    this.#shown = now;
    this.#show();
  }

  #open(): PaintBall | null {
    try {
      const { points, triangles } = this.page.painter.map;
      const ball = new PaintBall(this.querySelector('canvas')!, points, triangles);
      this.#unwatch = this.page.watchView(() => this.requestUpdate());
      return ball;
    } catch {
      return null;
    }
  }

  #show(): void {
    const { orientation, zUp } = this.page.view;
    this.#ball?.setView(orientation, zUp);
    this.#ball?.setCursor(this.#at, this.page.painter.brush.size);
    this.#ball?.draw();
  }

  readonly #down = (event: PointerEvent): void => {
    const point = this.#under(event);
    if (!point) return;
    event.preventDefault();
    const canvas = event.currentTarget as HTMLElement;
    canvas.setPointerCapture(event.pointerId);
    canvas.focus({ preventScroll: true });
    this.#at = point;
    this.page.painter.begin(point);
    this.requestUpdate();
  };

  readonly #move = (event: PointerEvent): void => {
    const point = this.#under(event);
    this.#at = point;
    if (point && this.page.painter.isPainting) this.page.painter.move(point);
    this.requestUpdate();
  };

  readonly #up = (): void => this.page.painter.end();

  readonly #leave = (): void => {
    if (this.page.painter.isPainting) return;
    this.#at = null;
    this.requestUpdate();
  };

  readonly #key = (event: KeyboardEvent): void => {
    const walk = walks[event.key];
    const here = this.#at ?? toFile([0, 0, 1], this.page.view);
    if (walk) this.#at = toFile(nudged(toSeen(here, this.page.view), ...walk), this.page.view);
    else if (event.key === ' ' || event.key === 'Enter') this.#dab(here);
    else return;
    event.preventDefault();
    event.stopPropagation();
    this.requestUpdate();
  };

  #dab(point: Vec3): void {
    this.#at = point;
    this.page.painter.begin(point);
    this.page.painter.end();
  }

  #under(event: PointerEvent): Vec3 | null {
    const box = (event.currentTarget as HTMLElement).getBoundingClientRect();
    const x = (2 * (event.clientX - box.left)) / box.width - 1;
    const y = 1 - (2 * (event.clientY - box.top)) / box.height;
    return this.#ball?.pick(x, y) ?? null;
  }
}

function sliderValue(event: Event): number {
  return (event.target as HTMLInputElement).valueAsNumber;
}

customElements.define('whittle-painter', WhittlePainter);
