import { existsSync, mkdirSync, readFileSync, statSync, writeFileSync } from 'node:fs';
import { picture } from '../browser/support/browser.ts';
import type { SavedFile } from '../browser/support/downloads.ts';
import type { Figure, Picture } from './figure.ts';
import type { Hand } from './hand.ts';

/** What is free of panels: while the view is turned, and beside the options of another tool. */
const free = {
  turning: { x: 120, y: 80, width: 735, height: 640 },
  beside: { x: 330, y: 80, width: 530, height: 640 },
} as const;

/** Keeps what is shown of the figures: pictures, recipes, files, and the page that they hang on. */
export class Showroom {
  readonly #folder: string;
  readonly #before = new Set<string>();

  constructor(folder: string) {
    this.#folder = folder;
    mkdirSync(folder, { recursive: true });
  }

  async take(figure: Figure, hand: Hand, files: readonly SavedFile[]): Promise<void> {
    const { page } = hand;
    for (const { name, bytes } of files) writeFileSync(`${this.#folder}/${name}`, bytes);
    if (figure.mesh?.bytes) writeFileSync(`${this.#folder}/${figure.mesh.title}`, figure.mesh.bytes());
    await page.keyboard.press('f');
    await this.#original(figure, hand);
    await figure.look?.(hand);
    if (figure.shows) await hand.takes(figure.shows);
    await this.#shoot(hand, figure.id, figure.shows ? free.beside : free.turning);
  }

  /** Takes a picture of a mesh as it is. */
  async takeStill({ id, look }: Picture, hand: Hand): Promise<void> {
    await hand.page.keyboard.press('f');
    await look?.(hand);
    await this.#shoot(hand, id, free.turning);
  }

  /** The file's own shape, once for each mesh. */
  async #original(figure: Picture, hand: Hand): Promise<void> {
    const name = originalOf(figure);
    if (this.#before.has(name)) return;
    this.#before.add(name);
    await hand.page.keyboard.down('b');
    await this.#shoot(hand, name, free.turning);
    await hand.page.keyboard.up('b');
  }

  async #shoot({ page }: Hand, name: string, clip: (typeof free)[keyof typeof free]): Promise<void> {
    await page.mouse.move(20, 780);
    await picture(page);
    writeFileSync(`${this.#folder}/${name}.jpg`, await page.screenshot({ clip, type: 'jpeg', quality: 78 }));
  }

  /** Writes the page of all that there are pictures of. */
  open(figures: readonly Picture[]): void {
    const shown = figures.filter(({ id }) => existsSync(`${this.#folder}/${id}.jpg`));
    const numbers = [...new Set(shown.map(({ of }) => of))];
    const originals = new Map(
      shown
        .filter(({ id }) => existsSync(`${this.#folder}/${id}.whittle.json`))
        .map((figure) => [originalOf(figure), figure.mesh?.title ?? 'Rabbit']),
    );
    const page = readFileSync(new URL('./showroom.html', import.meta.url), 'utf8')
      .replace('<!-- originals -->', () =>
        [...originals].map(([name, title]) => originalCard(name, title)).join('\n'),
      )
      .replace('<!-- figures -->', () =>
        numbers
          .map((of) =>
            this.#section(
              of,
              shown.filter((figure) => figure.of === of),
            ),
          )
          .join('\n'),
      );
    writeFileSync(`${this.#folder}/index.html`, page);
  }

  #section(of: string, figures: readonly Picture[]): string {
    const { paper, differs } = figures[0]!;
    return `<section>
<h2>${of}</h2>
<p>The paper: ${paper}.${differs ? ` ${differs}` : ''}</p>
<div class="row">
${figures.map((figure) => this.#card(figure)).join('\n')}
</div>
</section>`;
  }

  #card({ id, caption, mesh }: Picture): string {
    const on = mesh?.bytes ? `<a href="${mesh.title}" download>${mesh.title}</a>` : (mesh?.title ?? 'Rabbit');
    return `<figure><img src="${id}.jpg" alt="${caption}" loading="lazy">
<figcaption>${caption}<small>${on}${this.#recipe(`${id}.whittle.json`)}</small></figcaption></figure>`;
  }

  /** The way to a recipe; nothing where no recipe can say what is shown. */
  #recipe(name: string): string {
    const path = `${this.#folder}/${name}`;
    if (!existsSync(path)) return '';
    const size = Math.max(1, Math.round(statSync(path).size / 1024));
    const names = /"([^"]+\.png)"/.exec(readFileSync(path, 'utf8'))?.[1];
    const beside = names ? ` and the <a href="${names}" download>ball</a> that it names` : '';
    return ` · <a href="${name}" download>recipe</a>, ${size} KB${beside}`;
  }
}

function originalOf({ mesh }: Picture): string {
  return `original-${(mesh?.title ?? 'rabbit').toLowerCase().replace(/\..*$/, '')}`;
}

function originalCard(name: string, title: string): string {
  return `<figure><img src="${name}.jpg" alt="${title} as it is in the file" loading="lazy"><figcaption>${title}</figcaption></figure>`;
}
