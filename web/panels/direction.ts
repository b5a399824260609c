import { html, LitElement, svg } from 'lit';
import type { Vec3 } from '../../src/mesh/vectors.ts';
import { inWords, nudged, pointed } from '../app/view-directions.ts';

const turn = Math.PI / 18;
const steps: Readonly<Record<string, readonly [right: number, up: number]>> = {
  ArrowRight: [turn, 0],
  ArrowLeft: [-turn, 0],
  ArrowUp: [0, turn],
  ArrowDown: [0, -turn],
};

/** A little ball to choose a direction on: drag the arrow, beyond the rim it goes round to the back. Fires `direction`. */
export class WhittleDirection extends LitElement {
  static override properties = { seen: { attribute: false }, color: {} };
  /** As it is seen: right, up, towards the eye. */
  declare seen: Vec3;
  declare color: string;

  protected override createRenderRoot(): this {
    return this;
  }

  protected override render() {
    const [x, y, z] = this.seen;
    const degrees = Math.round((Math.atan2(y, x) * 180) / Math.PI);
    return html`
      <div
        class="direction" role="slider" tabindex="0" aria-label="Direction of the brush" aria-valuemin="-180" aria-valuemax="180"
        aria-valuenow=${degrees} aria-valuetext=${inWords(this.seen)} title="The normal to paint: drag the arrow"
        @pointerdown=${this.#down} @pointermove=${this.#drag} @keydown=${this.#key}
      >
        <svg viewBox="-1.25 -1.25 2.5 2.5" aria-hidden="true">
          ${z < 0 ? this.#arrow() : ''}
          <circle r="1" style="fill:${this.color}" fill-opacity=${z < 0 ? 0.75 : 1} />
          <circle r="1" class="rim" />
          ${z >= 0 ? this.#arrow() : ''}
        </svg>
      </div>`;
  }

  #arrow() {
    const [x, y, z] = this.seen;
    const tip = [1.14 * x, -1.14 * y] as const;
    const angle = (Math.atan2(tip[1], tip[0]) * 180) / Math.PI;
    const isFacing = Math.hypot(x, y) < 0.12;
    return svg`<g class="arrow" data-behind=${z < 0 ? '' : 'no'}>
      <line x1="0" y1="0" x2=${tip[0]} y2=${tip[1]} />
      ${
        isFacing
          ? svg`<circle r="0.16" />`
          : svg`<path d="M0.04 0L-0.3 0.17V-0.17z" transform="translate(${tip[0]} ${tip[1]}) rotate(${angle})" />`
      }
    </g>`;
  }

  readonly #down = (event: PointerEvent): void => {
    (event.currentTarget as HTMLElement).setPointerCapture(event.pointerId);
    this.#point(event);
  };

  readonly #drag = (event: PointerEvent): void => {
    if (event.buttons > 0) this.#point(event);
  };

  readonly #key = (event: KeyboardEvent): void => {
    const step = steps[event.key];
    if (!step) return;
    event.preventDefault();
    this.#fire(nudged(this.seen, ...step));
  };

  #point(event: PointerEvent): void {
    const box = (event.currentTarget as HTMLElement).getBoundingClientRect();
    const radius = box.width / 2.5;
    const x = (event.clientX - box.left - box.width / 2) / radius;
    const y = (box.top + box.height / 2 - event.clientY) / radius;
    this.#fire(pointed(x, y));
  }

  #fire(seen: Vec3): void {
    this.dispatchEvent(new CustomEvent('direction', { detail: seen }));
  }
}

customElements.define('whittle-direction', WhittleDirection);
