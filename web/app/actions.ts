import { Quaternion } from 'three';
import type { Beginning } from '../../src/editor/begin-project.ts';
import type { Editor } from '../../src/editor/editor.ts';
import type { Presenter } from '../../src/editor/presenter.ts';
import { activeStep } from '../../src/editor/project.ts';
import { imageParameter } from '../../src/editor/starting-step.ts';
import { type FormatInfo, fileNameEndings, isProjectFile } from '../../src/io/index.ts';
import { findMethod } from '../../src/methods/registry.ts';
import type { Viewer } from '../../src/viewer/viewer.ts';
import type { NormalPainter } from '../tools/paint-normals.ts';
import { chooseMesh } from './choose-mesh.ts';
import type { Comparing } from './comparing.ts';
import type { CubeActions } from './cube-actions.ts';
import { exportName, ownFormat } from './export.ts';
import { type FoundFile, found, readBeside, unpackArchives } from './found-files.ts';
import type { HandleActions } from './handle-actions.ts';
import type { ImageActions } from './image-actions.ts';
import type { LineActions } from './line-actions.ts';
import { obstacle } from './offered-methods.ts';
import type { Look, PageStore } from './page-state.ts';
import type { PlaneActions } from './plane-actions.ts';
import { imageEndings, imageNames } from './read-image.ts';
import { fetchSample, type Sample, sampleAddress, samples } from './samples.ts';
import { saveFile } from './save.ts';
import type { FoundRecipe, SavingActions } from './saving.ts';
import type { Selecting } from './selecting.ts';
import type { StrengthActions } from './strength-actions.ts';
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
  readonly cube: CubeActions;
  readonly planes: PlaneActions;
  readonly selecting: Selecting;
  readonly strength: StrengthActions;
  readonly lines: LineActions;
  readonly tools: ToolBelt;
  readonly comparing: Comparing;
  readonly saving: SavingActions;
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
  readonly cube: CubeActions;
  readonly planes: PlaneActions;
  readonly selecting: Selecting;
  readonly strength: StrengthActions;
  readonly lines: LineActions;
  readonly tools: ToolBelt;
  readonly comparing: Comparing;
  readonly saving: SavingActions;
  readonly #presenter: Presenter;
  readonly #viewer: Viewer | null;
  #openings = 0;

  constructor(parts: PageParts) {
    const { store, editor, styles, images, painter, handles, cube, planes, strength, selecting } = parts;
    const { lines, tools, comparing, saving, presenter, viewer } = parts;
    this.store = store;
    this.editor = editor;
    this.styles = styles;
    this.images = images;
    this.painter = painter;
    this.handles = handles;
    this.cube = cube;
    this.planes = planes;
    this.selecting = selecting;
    this.strength = strength;
    this.lines = lines;
    this.tools = tools;
    this.comparing = comparing;
    this.saving = saving;
    this.#presenter = presenter;
    this.#viewer = viewer;
  }

  /** Whether a person, or the page, has asked for a mesh. */
  get hasOpened(): boolean {
    return this.#openings > 0;
  }

  async openSample(sample: Sample, begin: Beginning = {}): Promise<void> {
    const turn = ++this.#openings;
    await this.#attempt(async () => {
      const address = sampleAddress(sample);
      const bytes = await fetchSample(sample);
      // Another one was asked for meanwhile.
      if (turn === this.#openings) await this.editor.open(bytes, sample.file, { address, ...begin });
    });
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

  /** Opens the project, the recipe or the mesh among some files, with what it refers to; says what it left out. An image alone goes on the mesh, or is a normal capture. */
  async openFiles(files: readonly FoundFile[]): Promise<void> {
    const { project } = this.store.state;
    const takesImages = project && imageParameter(findMethod(activeStep(project).method)) !== undefined;
    if (takesImages && files.length > 0 && files.every(({ name }) => imageNames.test(name)))
      return this.images.add(files);
    if (files.length === 1 && /\.png$/i.test(files[0]!.name)) return this.addStyles(files);
    this.#openings++;
    await this.#attempt(async () => {
      const project = await projectAmong(files);
      if (project) return this.saving.openProject(project.bytes, project.name);
      const all = await unpackArchives(files);
      const recipe = await this.saving.findRecipe(all);
      if (recipe && recipe.missing.length > 0) return this.#askFor(recipe, files);
      if (recipe && all.every((file) => recipe.taken.includes(file))) return this.saving.takeRecipe(recipe);
      await this.#openMesh(
        all.filter((file) => !recipe?.taken.includes(file)),
        recipe,
      );
    });
  }

  async #openMesh(files: readonly FoundFile[], found?: FoundRecipe): Promise<void> {
    const { mesh, note } = chooseMesh(files);
    if (!mesh && note) this.store.set({ notice: { tone: 'error', text: note } });
    if (!mesh) return;
    const bytes = new Uint8Array(await mesh.arrayBuffer());
    if (found) this.saving.adopt(found.assets);
    const begin = found ? { recipe: found.recipe, assets: found.assets } : {};
    await this.editor.open(bytes, mesh.name, begin, readBeside(mesh, files));
    if (note && !this.store.state.notice) this.store.set({ notice: { tone: 'note', text: note } });
  }

  /** A recipe waits for the files that it names. */
  #askFor({ name, missing }: FoundRecipe, files: readonly FoundFile[]): void {
    const text = `${name} names ${missing.join(', ')}. Drop ${missing.length === 1 ? 'that file' : 'those files'} together with it, or choose ${missing.length === 1 ? 'it' : 'them'}.`;
    const run = () => pickFiles('', (more) => void this.openFiles([...files, ...more]));
    this.store.set({ notice: { tone: 'note', text, action: { label: 'Choose', run } } });
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
/** What goes with a mesh, or holds it, or says what to do with it. */
const besideEndings = '.bin,.mtl,.png,.jpg,.jpeg,.json,.zip';

function pickFiles(endings: string, take: (files: readonly FoundFile[]) => void): void {
  const input = document.createElement('input');
  input.type = 'file';
  input.multiple = true;
  input.accept = endings;
  input.addEventListener('change', () => take([...(input.files ?? [])].map((file) => found(file))));
  input.click();
}

/** The project file among some files, if it is one. */
async function projectAmong(files: readonly FoundFile[]) {
  for (const { name, arrayBuffer } of files.filter((file) => /\.zip$/i.test(file.name))) {
    const bytes = new Uint8Array(await arrayBuffer());
    if (isProjectFile(bytes)) return { name, bytes };
  }
  return undefined;
}
