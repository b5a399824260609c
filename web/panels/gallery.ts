import { html, nothing } from 'lit';
import { repeat } from 'lit/directives/repeat.js';
import { activeStep } from '../../src/editor/project.ts';
import { styleParameter } from '../../src/editor/starting-step.ts';
import { findMethod } from '../../src/methods/registry.ts';
import { groups, type StyleEntry, type StyleGroup } from '../app/style-gallery.ts';
import { Thumbnails } from '../app/thumbnails.ts';
import { stepInGrid } from './grid-steps.ts';
import { icon } from './icons.ts';
import { PageElement } from './page-element.ts';
import './flow-view.ts';

/** The styles as little pictures. Arrow keys walk, Enter takes; a click restyles the mesh at once. */
export class WhittleGallery extends PageElement {
  static override properties = { open: { state: true } };
  /** All styles are to be seen, not only those around the chosen one. On a phone they are a strip, and all there. */
  declare open: boolean;
  readonly #thumbnails = new Thumbnails();
  #shownId = '';

  constructor() {
    super();
    this.open = false;
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.#thumbnails.stop();
  }

  get #parameter() {
    const { project } = this.state;
    return styleParameter(findMethod(project ? activeStep(project).method : ''));
  }

  /** A method that only takes a few directions is offered the convex shapes. */
  get #onlyShapes(): boolean {
    return this.#parameter?.mapping === 'closest';
  }

  protected override render() {
    const { offer, flow, pending, entries } = this.state.gallery;
    const painting = this.state.gallery.painting && !this.#onlyShapes;
    const offered = groups.filter(({ id }) => id === 'shapes' || !this.#onlyShapes);
    return html`
      <div class="gallery" role="listbox" ?hidden=${painting} ?data-open=${this.open} aria-label="Styles" aria-busy=${pending !== null} @keydown=${this.#key}>
        ${offered.map(({ id, title }) => this.#group(id, title, entries))}
      </div>
      ${offer ? this.#offer(offer.why) : nothing}
      ${flow ? html`<whittle-flow .flow=${flow}></whittle-flow>` : nothing}
      <div class="gallery-tools">
        <button type="button" class="button small show-all" data-act="all-styles" aria-expanded=${this.open} ?hidden=${painting} @click=${() => this.#fold(!this.open)}>${icon(this.open ? 'up' : 'down')}${this.open ? 'Fewer' : 'All'}</button>
        <button type="button" class="button small" data-act="add-style" title="Add a mesh, or a PNG of a ball that holds normals; dropping it here does the same" @click=${() => this.page.pickStyle()}>${icon('add')}Add</button>
        ${this.#onlyShapes ? nothing : html`<button type="button" class="button small" data-act="paint" aria-pressed=${painting} title="Paint normals on a ball" @click=${() => this.page.painter.toggle()}>${icon('brush')}Paint</button>`}
      </div>
    `;
  }

  protected override firstUpdated(): void {
    void this.page.styles.readAhead();
  }

  protected override updated(): void {
    const chosen = this.page.styles.chosenId;
    if (chosen !== this.#shownId) this.#reveal(chosen);
    this.#shownId = chosen;
    this.#thumbnails.look(this.querySelectorAll<HTMLCanvasElement>('.tile canvas'), (id) =>
      this.state.gallery.entries.find((entry) => entry.id === id),
    );
  }

  #fold(open: boolean): void {
    this.open = open;
    void this.updateComplete.then(() => this.#reveal(this.page.styles.chosenId));
  }

  /** Brings a tile into the gallery's own view; the panel around it stays where it is. */
  #reveal(id: string): void {
    const gallery = this.querySelector('.gallery');
    const tile = this.querySelector(`[data-style="${id}"]`);
    if (!gallery || !tile) return;
    const [outer, inner] = [gallery.getBoundingClientRect(), tile.getBoundingClientRect()];
    gallery.scrollTop += overhang(inner.top - groupTitleHeight, inner.bottom, outer.top, outer.bottom);
    gallery.scrollLeft += overhang(inner.left, inner.right, outer.left, outer.right);
  }

  #group(group: StyleGroup, title: string, entries: readonly StyleEntry[]) {
    const members = entries.filter((entry) => entry.group === group);
    return html`
      <div role="group" aria-label=${title}>
        <p class="group-title" aria-hidden="true">${title}</p>
        <div class="tiles" role="presentation">${repeat(members, ({ id }) => id, this.#tile)}</div>
      </div>`;
  }

  readonly #tile = ({ id, name }: StyleEntry) => {
    const { pending } = this.state.gallery;
    const chosen = this.page.styles.chosenId === id;
    return html`
      <button
        type="button" class="tile" role="option" data-style=${id} aria-selected=${chosen} tabindex=${chosen ? 0 : -1}
        ?data-pending=${pending === id} title=${name} @click=${() => this.#choose(id)}
      ><canvas width="128" height="128" data-picture=${id} aria-hidden="true"></canvas><span>${breakable(name)}</span></button>`;
  };

  #offer(why: string) {
    return html`
      <div class="offer" role="status">
        <p>${why} It can be read through the sphere instead, if it is closed and without handles.</p>
        <div>
          <button type="button" class="button small" data-act="accept-style" @click=${() => void this.page.styles.accept()}>Let it flow</button>
          <button type="button" class="button small bare" data-act="decline-style" @click=${() => this.page.styles.decline()}>Leave it</button>
        </div>
      </div>`;
  }

  #choose(id: string): void {
    const entry = this.state.gallery.entries.find((one) => one.id === id);
    if (entry) void this.page.styles.choose(entry);
  }

  readonly #key = (event: KeyboardEvent): void => {
    const tiles = [...this.querySelectorAll<HTMLElement>('.tile')];
    const here = tiles.indexOf(document.activeElement as HTMLElement);
    const to = stepInGrid(
      tiles.map((tile) => tile.getBoundingClientRect()),
      here,
      event.key,
    );
    if (to === null) return;
    event.preventDefault();
    event.stopPropagation();
    this.open = true;
    tiles[here]!.tabIndex = -1;
    tiles[to]!.tabIndex = 0;
    tiles[to]!.focus();
  };
}

const groupTitleHeight = 30;

/** How far a stretch has to move to lie within another. */
function overhang(from: number, to: number, outerFrom: number, outerTo: number): number {
  if (from < outerFrom) return from - outerFrom;
  return Math.max(0, to - outerTo);
}

/** Long names of solids may break before their last part. */
function breakable(name: string): string {
  return name.replace(/(?<=\w)hedron/, '\u00adhedron');
}

customElements.define('whittle-gallery', WhittleGallery);
