import type { Beginning } from '../../src/editor/begin-project.ts';
import type { Editor } from '../../src/editor/editor.ts';
import type { Assets, Project } from '../../src/editor/project.ts';
import { beginSaved, saveProject } from '../../src/editor/saved-project.ts';
import type { Engine } from '../../src/engine/client.ts';
import { nameOfPath, type ProjectFile, packProject, unpackProject } from '../../src/io/index.ts';
import {
  type Asset,
  filesNamedBy,
  formatRecipe,
  parseRecipe,
  type Recipe,
  readAsset,
} from '../../src/recipe/index.ts';
import { command, projectName, recipeName } from './export.ts';
import { beside, type FoundFile } from './found-files.ts';
import type { ImageActions } from './image-actions.ts';
import { fetchMesh, type Link, linkTo, recipeIn } from './links.ts';
import type { PageStore } from './page-state.ts';
import { readImage } from './read-image.ts';
import { copyText, saveFile } from './save.ts';
import type { StyleActions } from './style-actions.ts';

export interface SavingParts {
  readonly store: PageStore;
  readonly editor: Editor;
  readonly engine: Engine;
  readonly styles: StyleActions;
  readonly images: ImageActions;
}

/** A recipe that was dropped or picked, with the files that came with it. */
export interface FoundRecipe {
  readonly recipe: Recipe;
  /** Its file's name. */
  readonly name: string;
  readonly assets: Assets;
  /** The files that it names and that are neither with it nor known here. */
  readonly missing: readonly string[];
  /** The files that were taken for what it names, and itself. */
  readonly taken: readonly FoundFile[];
}

/** All that work leaves the page as, but for the mesh itself, and comes back as: recipes, projects, links, commands. */
export class SavingActions {
  readonly #parts: SavingParts;
  /** Hears of a project that was saved as a file. */
  onSaved: (project: Project) => void = () => {};

  constructor(parts: SavingParts) {
    this.#parts = parts;
  }

  /** Saves the steps for the command line and for other meshes. */
  saveRecipe(): void {
    const { project } = this.#parts.store.state;
    const recipe = this.#parts.editor.recipe();
    if (!project || !recipe) return;
    if (recipe.steps.length > 0) saveFile(new Blob([formatRecipe(recipe)]), recipeName(project));
    else this.#note(allOff);
  }

  /** Saves mesh, steps and all that they name in one file. */
  async saveProject(): Promise<void> {
    const { project } = this.#parts.store.state;
    if (!project) return;
    await this.#attempt(async () => {
      saveFile(new Blob([await packProject(saveProject(project))]), projectName(project));
      this.onSaved(project);
    });
  }

  async copyLink(): Promise<void> {
    const { project } = this.#parts.store.state;
    if (!project) return;
    const instead = { label: 'Save the project', run: () => void this.saveProject() };
    try {
      const link = linkTo(project, location.href);
      if (link === undefined)
        this.#note('These steps are too long for a link; send the project file instead.', instead);
      else await this.#copied(link, 'Copied a link to this shape.');
    } catch (thrown) {
      this.#note(sentence(thrown), instead);
    }
  }

  /** Copies the command that makes the same file; says what it needs besides the mesh. */
  async copyCommand(): Promise<void> {
    const { project } = this.#parts.store.state;
    if (!project) return;
    if (this.#parts.editor.recipe()?.steps.length === 0) return this.#note(allOff);
    const { text, needsProject } = command(project);
    if (!needsProject) return this.#copied(text, `Copied: ${text.split('\n')[0]}`);
    await this.#copied(
      text,
      `Copied. It works on ${projectName(project)}, which has all that the steps name.`,
      {
        label: 'Save it',
        run: () => void this.saveProject(),
      },
    );
  }

  /** Opens a project file. @throws WhittleError */
  openProject(bytes: Uint8Array<ArrayBuffer>, name: string): Promise<void> {
    return this.openSaved(unpackProject(bytes, name));
  }

  /** Opens a project as it was saved. @throws WhittleError */
  async openSaved(saved: ProjectFile): Promise<void> {
    const { engine, editor } = this.#parts;
    const begin = await beginSaved(saved, { engine, decodeImage: readImage });
    this.adopt(begin.assets ?? new Map());
    const { name, bytes } = saved.mesh;
    await editor.open(bytes, name, begin, async (path) => saved.beside.get(path));
  }

  /**
   * Opens what a link leads to; without a mesh of its own its recipe is for the mesh that there is.
   *
   * @param otherwise what to open if there is no mesh yet
   * @throws Error with a sentence about the link
   */
  async openLink(link: Link, otherwise: string): Promise<void> {
    const { editor, store } = this.#parts;
    const recipe = recipeIn(link);
    if (!link.src && recipe && store.state.project)
      return editor.takeRecipe(recipe, new Map(), 'The link’s recipe');
    const address = link.src ?? otherwise;
    const { name, bytes, readBeside } = await fetchMesh(address);
    const begin: Beginning = { address, ...(recipe ? { recipe } : {}) };
    await editor.open(bytes, name, begin, readBeside);
  }

  /** The recipe among some files, with what it names; undefined if there is none. @throws WhittleError for a broken one */
  async findRecipe(files: readonly FoundFile[]): Promise<FoundRecipe | undefined> {
    for (const file of files) {
      if (!/\.json$/i.test(file.name)) continue;
      const text = new TextDecoder().decode(await file.arrayBuffer());
      if (text.includes('"whittle"')) return this.#withAssets(parseRecipe(text, file.name), file, files);
    }
    return undefined;
  }

  /** Puts a recipe on the mesh that there is. */
  takeRecipe({ recipe, name, assets }: FoundRecipe): void {
    const { editor, store } = this.#parts;
    this.adopt(assets);
    editor.takeRecipe(recipe, assets, `Recipe ${name}`);
    const { length } = recipe.steps;
    const steps = length === 1 ? 'Its step is' : `Its ${length} steps are`;
    this.#note(`Took the recipe ${name}. ${steps} now on ${store.state.project?.source.name}.`);
  }

  /** Shows what the person brought with a recipe or a project where it can be chosen again. */
  adopt(assets: ReadonlyMap<string, Asset>): void {
    for (const [name, asset] of assets) {
      if (asset.kind === 'image') this.#parts.images.adopt(name, asset);
      else if (asset.kind !== 'sphere-field') this.#parts.styles.adopt(name, asset);
    }
  }

  async #withAssets(recipe: Recipe, file: FoundFile, files: readonly FoundFile[]): Promise<FoundRecipe> {
    const { engine, editor } = this.#parts;
    const find = beside(file, files);
    const assets = new Map<string, Asset>();
    const missing: string[] = [];
    const taken = [file];
    for (const named of filesNamedBy(recipe.steps)) {
      const found = find(named.name) ?? find(nameOfPath(named.name));
      if (found) {
        taken.push(found);
        const bytes = new Uint8Array(await found.arrayBuffer());
        assets.set(named.name, await readAsset(named, bytes, engine, readImage));
      } else if (!editor.asset(named.name)) missing.push(named.name);
    }
    return { recipe, name: file.name, assets, missing, taken };
  }

  async #copied(text: string, done: string, action?: { label: string; run: () => void }): Promise<void> {
    this.#note((await copyText(text)) ? done : text, action);
  }

  #note(text: string, action?: { label: string; run: () => void }): void {
    this.#parts.store.set({ notice: { tone: 'note', text, ...(action ? { action } : {}) } });
  }

  async #attempt(work: () => Promise<void>): Promise<void> {
    try {
      await work();
    } catch (thrown) {
      this.#parts.store.set({ notice: { tone: 'error', text: sentence(thrown) } });
    }
  }
}

const allOff = 'Every step is switched off; switch one on first.';

function sentence(thrown: unknown): string {
  return thrown instanceof Error ? thrown.message : String(thrown);
}
