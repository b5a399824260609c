import { Quaternion } from 'three';
import type { Workspace } from '../../src/editor/editor.ts';
import type { Beginning } from '../../src/editor/open-file.ts';
import type { Display } from '../../src/editor/presenter.ts';
import { type FormatInfo, fileNameEndings } from '../../src/io/index.ts';
import { findMethod } from '../../src/methods/registry.ts';
import type { Viewer } from '../../src/viewer/viewer.ts';
import type { Painter } from '../tools/paint-normals.ts';
import { chooseMesh } from './choose-mesh.ts';
import { commandLine, exportName, ownFormat } from './export.ts';
import type { PictureDesk } from './image-actions.ts';
import { obstacle, takesPicture } from './offered-methods.ts';
import { pictureEndings, pictureNames } from './read-image.ts';
import { fetchSample, type Sample, samples } from './samples.ts';
import { copyText, saveFile } from './save.ts';
import type { Look, Store } from './store.ts';
import type { StyleDesk } from './style-actions.ts';
import type { ViewTurn } from './view-directions.ts';

export interface PageParts {
  readonly store: Store;
  readonly workspace: Workspace;
  readonly styles: StyleDesk;
  readonly pictures: PictureDesk;
  readonly painter: Painter;
  readonly display: Display;
  /** Null where the browser draws no 3D. */
  readonly viewer: Viewer | null;
}

/** All that buttons, keys and drops can ask for. Panels see this and the store, nothing else. */
export class Page {
  readonly store: Store;
  readonly workspace: Workspace;
  readonly styles: StyleDesk;
  readonly pictures: PictureDesk;
  readonly painter: Painter;
  readonly #display: Display;
  readonly #viewer: Viewer | null;

  constructor({ store, workspace, styles, pictures, painter, display, viewer }: PageParts) {
    this.store = store;
    this.workspace = workspace;
    this.styles = styles;
    this.pictures = pictures;
    this.painter = painter;
    this.#display = display;
    this.#viewer = viewer;
  }

  async openSample(sample: Sample, begin: Beginning = {}): Promise<void> {
    await this.#attempt(async () => this.workspace.open(await fetchSample(sample), sample.file, begin));
  }

  /** Another method; where the mesh is not made for it, says why and what would be. */
  chooseMethod(id: string): void {
    const { document } = this.store.state;
    const method = findMethod(id);
    if (!document || !method) return;
    const text = obstacle(method, document);
    if (text !== undefined) {
      const sample = samples.find(({ isForPictures }) => isForPictures)!;
      const run = () => void this.openSample(sample, { method, picture: this.pictures.chosen });
      this.store.set({
        notice: { tone: 'note', text, action: { label: `Try the ${sample.title.toLowerCase()}`, run } },
      });
    } else if (takesPicture(method)) this.pictures.choose(this.pictures.chosen);
    else void this.styles.chooseMethod(id);
  }

  /** Opens the mesh among some files; says what it left out. A picture alone goes on the mesh, or is a normal capture. */
  async openFiles(files: readonly File[]): Promise<void> {
    const takesPictures = takesPicture(findMethod(this.store.state.document?.method ?? ''));
    if (takesPictures && files.length > 0 && files.every(({ name }) => pictureNames.test(name)))
      return this.pictures.add(files);
    if (files.length === 1 && /\.png$/i.test(files[0]!.name)) return this.addStyles(files);
    const { mesh, note } = chooseMesh(files);
    if (!mesh) {
      if (note) this.store.set({ notice: { tone: 'error', text: note } });
      return;
    }
    await this.#attempt(async () => {
      await this.workspace.open(new Uint8Array(await mesh.arrayBuffer()), mesh.name);
      if (note && !this.store.state.notice) this.store.set({ notice: { tone: 'note', text: note } });
    });
  }

  pickFile(): void {
    pickFiles(meshEndings, (files) => void this.openFiles(files));
  }

  /** Makes styles of meshes and normal captures; the last one is put on. */
  async addStyles(files: readonly File[]): Promise<void> {
    for (const file of files)
      await this.#attempt(async () => this.styles.add(new Uint8Array(await file.arrayBuffer()), file.name));
  }

  pickStyle(endings = `.png,${meshEndings}`): void {
    pickFiles(endings, (files) => void this.addStyles(files));
  }

  pickPicture(): void {
    pickFiles(pictureEndings, (files) => void this.pictures.add(files));
  }

  saveCapture(): void {
    saveFile(new Blob([this.painter.picture()]), 'painted.png');
  }

  /** From where one looks at the file's axes. */
  get view(): ViewTurn {
    return this.#viewer?.view ?? { orientation: new Quaternion(), zUp: false };
  }

  /** Calls the listener whenever {@link view} has changed, until the returned function is called. */
  watchView(listener: () => void): () => void {
    return this.#viewer?.onTurn(listener) ?? (() => {});
  }

  async export(format?: FormatInfo): Promise<void> {
    const { document } = this.store.state;
    if (!document) return;
    const chosen = format ?? ownFormat(document);
    const written = await this.workspace.write(chosen.id);
    if (written) saveFile(new Blob([written.bytes]), exportName(written.document, chosen.ending));
  }

  async saveScreenshot(): Promise<void> {
    const { document } = this.store.state;
    if (!document || !this.#viewer) return;
    const background = getComputedStyle(globalThis.document.body).backgroundColor;
    await this.#attempt(async () =>
      saveFile(await this.#viewer!.snapshot(background), exportName(document, '.png')),
    );
  }

  async copyCommand(): Promise<void> {
    const { document } = this.store.state;
    if (!document) return;
    const line = commandLine(document);
    const copied = await copyText(line);
    this.store.set({ notice: { tone: 'note', text: copied ? `Copied: ${line}` : line } });
  }

  look(change: Partial<Look>): void {
    const look = { ...this.store.state.look, ...change };
    this.store.set({ look });
    this.#viewer?.setShading(look.shading);
    this.#display.compare(look.comparing);
  }

  fit(): void {
    this.#viewer?.fit();
  }

  dismiss(): void {
    this.store.set({ notice: null });
  }

  async #attempt(work: () => Promise<void>): Promise<void> {
    try {
      await work();
    } catch (thrown) {
      const text = thrown instanceof Error ? thrown.message : String(thrown);
      this.store.set({ notice: { tone: 'error', text } });
    }
  }
}

const meshEndings = fileNameEndings.join();

function pickFiles(endings: string, take: (files: readonly File[]) => void): void {
  const input = document.createElement('input');
  input.type = 'file';
  input.multiple = true;
  input.accept = endings;
  input.addEventListener('change', () => take([...(input.files ?? [])]));
  input.click();
}
