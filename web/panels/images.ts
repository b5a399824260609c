import { html, nothing } from 'lit';
import { repeat } from 'lit/directives/repeat.js';
import type { WhittleDocument } from '../../src/editor/project.ts';
import { shaded } from '../../src/inputs/images/shade.ts';
import { laid, type Picture } from '../app/image-gallery.ts';
import { icon } from './icons.ts';
import { PageElement } from './page-element.ts';

const side = 112;

/** Pictures to lay on the mesh, each as the relief that it makes. */
export class WhittlePictures extends PageElement {
  readonly #drawn = new WeakMap<HTMLCanvasElement, string>();

  protected override render() {
    const { offered } = this.page.pictures;
    return html`
      <fieldset class="tiles pictures">
        <legend class="hidden">Picture</legend>
        ${repeat(offered, ({ id }) => id, this.#tile)}
      </fieldset>
      <div class="gallery-tools">
        <button type="button" class="button small" data-act="add-picture" title="A normal map, or any picture whose brightness is height; dropping it here does the same" @click=${() => this.page.pickPicture()}>${icon('add')}Add a picture</button>
      </div>
    `;
  }

  protected override updated(): void {
    for (const canvas of this.querySelectorAll('canvas')) {
      const entry = this.page.pictures.offered.find(({ id }) => id === canvas.dataset.picture);
      if (!entry || this.#drawn.get(canvas) === entry.id) continue;
      this.#drawn.set(canvas, entry.id);
      canvas.getContext('2d')?.putImageData(new ImageData(shaded(entry.read(), side), side, side), 0, 0);
    }
  }

  readonly #tile = (entry: Picture) => html`
    <label class="tile" title=${entry.name}>
      <input type="radio" name="picture" .checked=${this.page.pictures.chosen === entry} @change=${() => this.page.pictures.choose(entry)} />
      <canvas width=${side} height=${side} data-picture=${entry.id} aria-hidden="true"></canvas><span>${entry.name}</span>
    </label>`;
}

/** What a person should know of the picture on the mesh; if it cannot be laid there, the run has said so. */
export function remarkOn({ picture, mesh, parameters }: WhittleDocument) {
  let remark: string | undefined;
  try {
    remark = picture ? laid(picture, mesh, parameters).remark : undefined;
  } catch {}
  return html`<p class="remark" role="status" ?hidden=${!remark}>${remark ?? nothing}</p>`;
}

customElements.define('whittle-pictures', WhittlePictures);
