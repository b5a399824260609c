import { Quaternion } from 'three';
import type { Beginning } from '../../src/editor/begin-project.ts';
import type { Editor } from '../../src/editor/editor.ts';
import type { Presenter } from '../../src/editor/presenter.ts';
import { activeStep } from '../../src/editor/project.ts';
import { imageParameter } from '../../src/editor/starting-step.ts';
import { type FormatInfo, fileNameEndings } from '../../src/io/index.ts';
import { findMethod } from '../../src/methods/registry.ts';
import { formatRecipe } from '../../src/recipe/index.ts';
import type { Viewer } from '../../src/viewer/viewer.ts';
import type { NormalPainter } from '../tools/paint-normals.ts';
import { chooseMesh } from './choose-mesh.ts';
import { commandLine, exportName, ownFormat, recipeName } from './export.ts';
import { beside, type FoundFile, found, unpackArchives } from './found-files.ts';
import type { HandleActions } from './handle-actions.ts';
import type { ImageActions } from './image-actions.ts';
import { obstacle } from './offered-methods.ts';
import type { Look, PageStore } from './page-state.ts';
import { imageEndings, imageNames } from './read-image.ts';
import { fetchSample, type Sample, samples } from './samples.ts';
import { copyText, saveFile } from './save.ts';
import type { StyleActions } from './style-actions.ts';
import type { ToolBelt } from './tool-belt.ts';
import type { ViewTurn } from './view-directions.ts';

export interface PageParts {
  readonly store: PageStore;
  readonly editor: Editor;
  readonly styles: StyleActions;
  readonly images: ImageActions;
  readonly painter: NormalPainter;
  readonly handles: HandleActions;
  readonly tools: ToolBelt;
  readonly presenter: Presenter;
  /** Null where the browser draws no 3D. */
  readonly viewer: Viewer | null;
}

/** All that buttons, keys and drops can ask for. Panels see this and the store, nothing else. */
export class Page {
  readonly store: PageStore;
  readonly editor: Editor;
  readonly styles: StyleActions;
  readonly images: ImageActions;
  readonly painter: NormalPainter;
  readonly handles: HandleActions;
  readonly tools: ToolBelt;
  readonly #presenter: Presenter;
  readonly #viewer: Viewer | null;

  constructor({ store, editor, styles, images, painter, handles, tools, presenter, viewer }: PageParts) {
    this.store = store;
    this.editor = editor;
    this.styles = styles;
    this.images = images;
    this.painter = painter;
    this.handles = handles;
    this.tools = tools;
    this.#presenter = presenter;
    this.#viewer = viewer;
  }

  async openSample(sample: Sample, begin: Beginning = {}): Promise<void> {
    await this.#attempt(async () => this.editor.open(await fetchSample(sample), sample.file, begin));
  }

  /** Another method for the active step; where the mesh is not made for it, says why and what would be. */
  chooseMethod(id: string): void {
    const { project } = this.store.state;
    const method = findMethod(id);
    if (!project || !method) return;
    const text = obstacle(method, project.mesh);
    if (text !== undefined) {
      const sample = samples.find(({ isForImages }) => isForImages)!;
      const run = () => void this.openSample(sample, { method: id });
      this.store.set({
        notice: { tone: 'note', text, action: { label: `Try the ${sample.title.toLowerCase()}`, run } },
      });
    } else if (imageParameter(method) !== undefined) void this.images.choose(this.images.chosen);
    else void this.styles.chooseMethod(id);
  }

  /** Opens the mesh among some files, with what it refers to; says what it left out. An image alone goes on the mesh, or is a normal capture. */
  async openFiles(files: readonly FoundFile[]): Promise<void> {
    const { project } = this.store.state;
    const takesImages = project && imageParameter(findMethod(activeStep(project).method)) !== undefined;
    if (takesImages && files.length > 0 && files.every(({ name }) => imageNames.test(name)))
      return this.images.add(files);
    if (files.length === 1 && /\.png$/i.test(files[0]!.name)) return this.addStyles(files);
    await this.#attempt(async () => {
      const all = await unpackArchives(files);
      const { mesh, note } = chooseMesh(all);
      if (!mesh && note) this.store.set({ notice: { tone: 'error', text: note } });
      if (!mesh) return;
      const bytes = new Uint8Array(await mesh.arrayBuffer());
      await this.editor.open(bytes, mesh.name, {}, beside(mesh, all));
      if (note && !this.store.state.notice) this.store.set({ notice: { tone: 'note', text: note } });
    });
  }

  pickFile(): void {
    pickFiles(`${meshEndings},${besideEndings}`, (files) => void this.openFiles(files));
  }

  /** Makes styles of meshes and normal captures; the last one is put on. */
  async addStyles(files: readonly FoundFile[]): Promise<void> {
    for (const file of files)
      await this.#attempt(async () => this.styles.add(new Uint8Array(await file.arrayBuffer()), file.name));
  }

  pickStyle(endings = `.png,${meshEndings}`): void {
    pickFiles(endings, (files) => void this.addStyles(files));
  }

  pickImage(): void {
    pickFiles(imageEndings, (files) => void this.images.add(files));
  }

  saveCapture(): void {
    saveFile(new Blob([this.painter.capture()]), this.painter.name);
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
    const { project } = this.store.state;
    if (!project) return;
    const chosen = format ?? ownFormat(project);
    const written = await this.editor.write(chosen.id);
    if (written) saveFile(new Blob([written.bytes]), exportName(written.project, chosen.ending));
  }

  async saveSnapshot(): Promise<void> {
    const { project } = this.store.state;
    if (!project || !this.#viewer) return;
    const background = getComputedStyle(document.body).backgroundColor;
    await this.#attempt(async () =>
      saveFile(await this.#viewer!.snapshot(background), exportName(project, '.png')),
    );
  }

  /** Saves the stack for the command line and for other meshes. */
  saveRecipe(): void {
    const { project } = this.store.state;
    const recipe = this.editor.recipe();
    if (!project || !recipe) return;
    if (recipe.steps.length > 0) saveFile(new Blob([formatRecipe(recipe)]), recipeName(project));
    else
      this.store.set({ notice: { tone: 'note', text: 'Every step is switched off; switch one on first.' } });
  }

  async copyCommand(): Promise<void> {
    const { project } = this.store.state;
    if (!project) return;
    const line = commandLine(project);
    const copied = await copyText(line);
    this.store.set({ notice: { tone: 'note', text: copied ? `Copied: ${line}` : line } });
  }

  look(change: Partial<Look>): void {
    const look = { ...this.store.state.look, ...change };
    this.store.set({ look });
    this.#viewer?.setShading(look.shading);
    this.#presenter.compare(look.comparing);
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
/** What goes with a mesh, or holds it. */
const besideEndings = '.bin,.mtl,.png,.jpg,.jpeg,.zip';

function pickFiles(endings: string, take: (files: readonly FoundFile[]) => void): void {
  const input = document.createElement('input');
  input.type = 'file';
  input.multiple = true;
  input.accept = endings;
  input.addEventListener('change', () => take([...(input.files ?? [])].map((file) => found(file))));
  input.click();
}
