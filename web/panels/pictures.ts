import { html, nothing } from 'lit';
import { repeat } from 'lit/directives/repeat.js';
import { shaded } from '../../src/textures/shade.ts';
import { laid, type PictureEntry } from '../document/pictures.ts';
import { icon } from './icons.ts';
import { PageElement } from './page-element.ts';

const side = 112;

/** Pictures to lay on the mesh, each as the relief that it makes. */
export class WhittlePictures extends PageElement {
  readonly #drawn = new WeakMap<HTMLCanvasElement, string>();

  protected override render() {
    const { pictures, document } = this.state;
    const { picture, mesh, parameters } = document!;
    const remark = picture && laid(picture, mesh, Number(parameters.repeat)).remark;
    return html`
      <fieldset class="tiles pictures">
        <legend class="hidden">Picture</legend>
        ${repeat(pictures, ({ id }) => id, this.#tile)}
      </fieldset>
      <div class="gallery-tools">
        <button type="button" class="button small" data-act="add-picture" title="A normal map, or any picture whose brightness is height; dropping it here does the same" @click=${() => this.page.pickPicture()}>${icon('add')}Add a picture</button>
      </div>
      ${remark ? html`<p class="remark" role="status">${remark}</p>` : nothing}
    `;
  }

  protected override updated(): void {
    for (const canvas of this.querySelectorAll('canvas')) {
      const entry = this.state.pictures.find(({ id }) => id === canvas.dataset.picture);
      if (!entry || this.#drawn.get(canvas) === entry.id) continue;
      this.#drawn.set(canvas, entry.id);
      canvas.getContext('2d')?.putImageData(new ImageData(shaded(entry.texture(), side), side, side), 0, 0);
    }
  }

  readonly #tile = (entry: PictureEntry) => html`
    <label class="tile" title=${entry.name}>
      <input type="radio" name="picture" .checked=${this.page.pictures.chosenId === entry.id} @change=${() => this.page.pictures.choose(entry)} />
      <canvas width=${side} height=${side} data-picture=${entry.id} aria-hidden="true"></canvas><span>${entry.name}</span>
    </label>`;
}

customElements.define('whittle-pictures', WhittlePictures);
