import type { Viewer } from '../../src/viewer/viewer.ts';
import type { Display } from '../document/display.ts';
import { commandLine, exportName, type Format, ownFormat } from '../document/formats.ts';
import { fetchSample, type Sample } from '../document/samples.ts';
import type { Look, Store } from '../document/store.ts';
import type { Workspace } from '../document/workspace.ts';
import { chooseMesh } from './choose-mesh.ts';
import { copyText, saveFile } from './save.ts';

export interface PageParts {
  readonly store: Store;
  readonly workspace: Workspace;
  readonly display: Display;
  /** Null where the browser draws no 3D. */
  readonly viewer: Viewer | null;
}

/** All that buttons, keys and drops can ask for. Panels see this and the store, nothing else. */
export class Page {
  readonly store: Store;
  readonly workspace: Workspace;
  readonly #display: Display;
  readonly #viewer: Viewer | null;

  constructor({ store, workspace, display, viewer }: PageParts) {
    this.store = store;
    this.workspace = workspace;
    this.#display = display;
    this.#viewer = viewer;
  }

  async openSample(sample: Sample): Promise<void> {
    await this.#attempt(async () => this.workspace.open(await fetchSample(sample), sample.file));
  }

  /** Opens the mesh among some files; says what it left out. */
  async openFiles(files: readonly File[]): Promise<void> {
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
    const input = document.createElement('input');
    input.type = 'file';
    input.multiple = true;
    input.accept = '.obj,.stl,.ply,.off,.glb,.gltf';
    input.addEventListener('change', () => void this.openFiles([...(input.files ?? [])]));
    input.click();
  }

  async export(format?: Format): Promise<void> {
    const { document } = this.store.state;
    if (!document) return;
    const chosen = format ?? ownFormat(document);
    const written = await this.workspace.write(chosen.id);
    if (written) saveFile(new Blob([written.bytes]), exportName(written.document, chosen));
  }

  async saveScreenshot(): Promise<void> {
    const { document } = this.store.state;
    if (!document || !this.#viewer) return;
    const background = getComputedStyle(globalThis.document.body).backgroundColor;
    await this.#attempt(async () =>
      saveFile(
        await this.#viewer!.snapshot(background),
        exportName(document, { id: 'png', extension: 'png', label: 'PNG' }),
      ),
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
