import { html } from 'lit';
import { sampleSphere } from '../../src/inputs/fields/sphere-field.ts';
import { icosphere } from '../../src/inputs/styles/icosphere.ts';
import { row, type Vec3 } from '../../src/mesh/vectors.ts';
import { canvasPointer } from '../../src/viewer/canvas-tool.ts';
import { PaintBall } from '../../src/viewer/paint-ball.ts';
import { darkTheme, lightTheme } from '../../src/viewer/stage.ts';
import { strengthColor } from '../app/color-ramp.ts';
import { inWords, nudged, toFile, toSeen } from '../app/view-directions.ts';
import type { PaintStrength } from '../tools/paint-strength.ts';
import { PageElement } from './page-element.ts';

const step = Math.PI / 24;
const walks: Readonly<Record<string, readonly [number, number]>> = {
  ArrowRight: [step, 0],
  ArrowLeft: [-step, 0],
  ArrowUp: [0, step],
  ArrowDown: [0, -step],
};

const byKey = { pressure: 1, shift: false, ctrl: false, alt: false };
const sphere = icosphere(5);

/** Every direction a surface can look in, as a ball that is painted with strength and seen from where the mesh is. */
export class WhittleStrengthBall extends PageElement {
  static override properties = { tool: { attribute: false } };
  declare tool: PaintStrength;
  #ball: PaintBall | null = null;
  /** Where the brush is, on the ball. */
  #at: Vec3 | null = null;
  #unwatch: (() => void) | null = null;
  #shown: readonly unknown[] | null = null;

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.tool.onBall = () => {};
    this.tool.light(null);
    this.#unwatch?.();
    this.#ball?.dispose();
    this.#unwatch = this.#ball = this.#shown = null;
  }

  protected override render() {
    const spoken = this.#at ? inWords(toSeen(this.#at, this.page.view)) || 'the middle' : '';
    return html`
      <canvas
        class="ball" tabindex="0" role="application"
        aria-label="Strength by direction. Arrow keys move the brush, Space paints. ${spoken && `The brush is at: ${spoken}.`}"
        @pointerdown=${this.#down} @pointermove=${this.#move} @pointerup=${this.#up} @pointercancel=${this.#lost}
        @pointerleave=${this.#leave} @keydown=${this.#key} @blur=${this.#leave}
      ></canvas>`;
  }

  protected override updated(): void {
    this.#ball ??= this.#open();
    this.#draw();
  }

  #open(): PaintBall | null {
    try {
      const ball = new PaintBall(this.querySelector('canvas')!, sphere.points, sphere.triangles);
      this.#unwatch = this.page.watchView(() => this.#draw());
      this.tool.onBall = () => this.#draw();
      return ball;
    } catch {
      return null;
    }
  }

  #draw(): void {
    const ball = this.#ball;
    if (!ball || !this.isConnected) return;
    const { field, pointed, ballRadius } = this.tool;
    const { theme = 'light' } = document.documentElement.dataset;
    const { orientation, zUp } = this.page.view;
    const { x, y, z, w } = orientation;
    const cursor = this.#at ?? pointed;
    const now = [field?.values, theme, x, y, z, w, cursor, ballRadius] as const;
    if (this.#shown?.every((value, k) => value === now[k])) return;
    if (this.#shown?.[1] !== theme) ball.setTheme(theme === 'dark' ? darkTheme : lightTheme);
    if (!this.#shown || this.#shown[0] !== field?.values || this.#shown[1] !== theme) {
      const colors = new Float32Array(sphere.points.length);
      for (let v = 0; 3 * v < colors.length; v++)
        colors.set(strengthColor(field ? sampleSphere(field, row(sphere.points, v)) : 1), 3 * v);
      ball.setColors(colors);
    }
    this.#shown = now;
    ball.setView(orientation, zUp);
    // What is pointed at on the mesh is a point, not a brush.
    ball.setCursor(cursor, this.#at ? (ballRadius * 180) / Math.PI : 4);
    ball.draw();
  }

  readonly #down = (event: PointerEvent): void => {
    const point = this.#under(event);
    if (!point) return;
    event.preventDefault();
    const canvas = event.currentTarget as HTMLElement;
    canvas.setPointerCapture(event.pointerId);
    canvas.focus({ preventScroll: true });
    this.#at = point;
    this.tool.beginBall(point, canvasPointer(event, canvas));
    this.#draw();
  };

  readonly #move = (event: PointerEvent): void => {
    this.#at = this.#under(event);
    if (this.#at && this.tool.isOnBall)
      this.tool.moveBall(this.#at, canvasPointer(event, event.currentTarget as HTMLElement).pressure);
    this.tool.light(this.#at);
    this.#draw();
  };

  readonly #up = (): void => this.tool.endBall();
  readonly #lost = (): void => {
    if (this.tool.isOnBall) this.tool.cancel();
  };

  readonly #leave = (): void => {
    if (this.tool.isOnBall) return;
    this.#at = null;
    this.tool.light(null);
    this.#draw();
  };

  readonly #key = (event: KeyboardEvent): void => {
    const walk = walks[event.key];
    const here = this.#at ?? toFile([0, 0, 1], this.page.view);
    if (walk) this.#at = toFile(nudged(toSeen(here, this.page.view), ...walk), this.page.view);
    else if (event.key === ' ' || event.key === 'Enter') this.#dab(here);
    else return;
    event.preventDefault();
    event.stopPropagation();
    this.tool.light(this.#at);
    this.requestUpdate();
  };

  #dab(point: Vec3): void {
    this.#at = point;
    this.tool.beginBall(point, byKey);
    this.tool.endBall();
  }

  #under(event: PointerEvent): Vec3 | null {
    const box = (event.currentTarget as HTMLElement).getBoundingClientRect();
    const x = (2 * (event.clientX - box.left)) / box.width - 1;
    const y = 1 - (2 * (event.clientY - box.top)) / box.height;
    return this.#ball?.pick(x, y) ?? null;
  }
}

customElements.define('whittle-strength-ball', WhittleStrengthBall);
