import { html, LitElement } from 'lit';
import { Portraits } from '../../src/viewer/portraits.ts';
import { darkTheme, lightTheme } from '../../src/viewer/stage.ts';
import type { Flow } from '../app/page-state.ts';

/** A style mesh on its way to the sphere, as it happens. */
export class WhittleFlow extends LitElement {
  static override properties = { flow: { attribute: false } };
  declare flow: Flow;
  #portraits: Portraits | null = null;

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.#portraits?.dispose();
    this.#portraits = null;
  }

  protected override createRenderRoot(): this {
    return this;
  }

  protected override render() {
    return html`
      <canvas class="flow-picture" width="192" height="192" aria-hidden="true"></canvas>
      <p role="status">${this.flow.name} flows to the sphere; where its normals arrive is its style.</p>`;
  }

  protected override updated(): void {
    const { mesh, positions } = this.flow;
    try {
      const isDark = document.documentElement.dataset.theme === 'dark';
      this.#portraits ??= new Portraits(192, isDark ? darkTheme : lightTheme);
      const now = { positions: Float64Array.from(positions), triangles: mesh.triangles };
      this.#portraits.draw({ mesh: now }, this.querySelector('canvas')!);
    } catch {
      // Without WebGL the sentence has to do.
    }
  }
}

customElements.define('whittle-flow', WhittleFlow);
