import { toFailure } from '../../src/mesh/failure.ts';
import { methods } from '../../src/methods/registry.ts';
import { textureOf } from '../../src/textures/texture.ts';
import type { ChosenPicture } from '../document/document.ts';
import { startingParameters, takesPicture } from '../document/offered-methods.ts';
import { builtInPictures, ownPicture, type PictureEntry, startingRepeat } from '../document/pictures.ts';
import type { Store } from '../document/store.ts';
import type { Workspace } from '../document/workspace.ts';
import { readPicture } from './read-picture.ts';

/** All that can be done with pictures: choose one, bring one. */
export class PictureDesk {
  readonly #store: Store;
  readonly #workspace: Workspace;

  constructor(store: Store, workspace: Workspace) {
    this.#store = store;
    this.#workspace = workspace;
  }

  /** The picture that the document has or, before any was chosen, would get. */
  get chosenId(): string {
    return this.#store.state.document?.picture?.id ?? builtInPictures[0]!.id;
  }

  /** Lays a picture on the mesh and makes shape of it. */
  choose(entry: PictureEntry): void {
    const { document } = this.#store.state;
    const method = methods.find(takesPicture);
    if (!document || !method) return;
    const { id, name, source, isOwn } = entry;
    try {
      const picture: ChosenPicture = { id, name, source, isPattern: !isOwn, texture: entry.texture() };
      const parameters =
        document.method === method.id
          ? { ...document.parameters, repeat: startingRepeat(picture, document.mesh) }
          : startingParameters(method, { ...document, picture });
      this.#workspace.restyle({ method: method.id, parameters, picture }, name);
    } catch (thrown) {
      this.#fail(thrown);
    }
  }

  /** The method, with the picture that was chosen last. */
  chooseMethod(): void {
    const entry = this.#store.state.pictures.find(({ id }) => id === this.chosenId);
    if (entry) this.choose(entry);
  }

  /** Takes pictures of the person's own; the last one is put on. */
  async add(files: readonly File[]): Promise<void> {
    for (const file of files) {
      try {
        const entry = ownPicture(file.name, textureOf(await readPicture(file), file.name));
        this.#store.set({ pictures: [...this.#store.state.pictures, entry] });
        this.choose(entry);
      } catch (thrown) {
        this.#fail(thrown);
      }
    }
  }

  #fail(thrown: unknown): void {
    this.#store.set({ notice: { tone: 'error', text: toFailure(thrown).message } });
  }
}
