import { html, nothing } from 'lit';
import { repeat } from 'lit/directives/repeat.js';
import { shaded } from '../../src/inputs/images/shade.ts';
import type { ImageEntry } from '../app/image-gallery.ts';
import { icon } from './icons.ts';
import { PageElement } from './page-element.ts';

const side = 112;

/** Images to lay on the mesh, each drawn as the relief that it makes, and what there is to say of the chosen one. */
export class WhittleImages extends PageElement {
  readonly #drawn = new WeakMap<HTMLCanvasElement, string>();

  protected override render() {
    const { offered, remark } = this.page.images;
    return html`
      <fieldset class="tiles images">
        <legend class="hidden">Image</legend>
        ${repeat(offered, ({ id }) => id, this.#tile)}
      </fieldset>
      <div class="gallery-tools">
        <button type="button" class="button small" data-act="add-image" title="A normal map, or any image whose brightness is height; dropping it here does the same" @click=${() => this.page.pickImage()}>${icon('add')}Add an image</button>
      </div>
      <p class="remark" role="status" ?hidden=${!remark}>${remark ?? nothing}</p>
    `;
  }

  protected override updated(): void {
    for (const canvas of this.querySelectorAll('canvas')) {
      const entry = this.page.images.offered.find(({ id }) => id === canvas.dataset.picture);
      if (!entry || this.#drawn.get(canvas) === entry.id) continue;
      this.#drawn.set(canvas, entry.id);
      canvas.getContext('2d')?.putImageData(new ImageData(shaded(entry.texture(), side), side, side), 0, 0);
    }
  }

  readonly #tile = (entry: ImageEntry) => html`
    <label class="tile" title=${entry.name}>
      <input type="radio" name="image" .checked=${this.page.images.chosen === entry} @change=${() => void this.page.images.choose(entry)} />
      <canvas width=${side} height=${side} data-picture=${entry.id} aria-hidden="true"></canvas><span>${entry.name}</span>
    </label>`;
}

customElements.define('whittle-images', WhittleImages);
