import type { Workspace } from '../../src/editor/editor.ts';
import type { Source } from '../../src/editor/project.ts';
import { toFailure } from '../../src/mesh/failure.ts';
import { methods } from '../../src/methods/registry.ts';
import { ownPicture, type Picture, startingRepeat } from './image-gallery.ts';
import { startingParameters, takesPicture } from './offered-methods.ts';
import { readPicture } from './read-image.ts';
import type { Store } from './store.ts';

/** All that can be done with pictures: choose one, bring one. */
export class PictureDesk {
  readonly #store: Store;
  readonly #workspace: Workspace;
  /** Whose normal map was unpacked last. */
  #source: Source | null = null;

  constructor(store: Store, workspace: Workspace) {
    this.#store = store;
    this.#workspace = workspace;
    store.subscribe(({ document }) => {
      if (document && document.source !== this.#source) void this.#unpack(document.source);
    });
  }

  /** Those that can be laid on the mesh: a file's own normal map first, and on no other mesh. */
  get offered(): readonly Picture[] {
    const { pictures, document } = this.#store.state;
    const own = pictures.filter(({ file }) => file && file === document?.source);
    return [...own, ...pictures.filter(({ file }) => !file)];
  }

  /** Lays a picture on the mesh and makes shape of it. */
  choose(picture: Picture): void {
    const { document } = this.#store.state;
    const method = methods.find(takesPicture);
    if (!document || !method) return;
    const starting = startingParameters(method, { ...document, picture });
    // What the person set stays, but for how this very picture is read and how often it comes.
    const { reading, green, ...kept } = document.method === method.id ? document.parameters : starting;
    const parameters = { ...starting, ...kept, repeat: startingRepeat(picture, document.mesh) };
    this.#workspace.restyle({ method: method.id, parameters, picture }, picture.name);
  }

  /** The picture that was chosen last, or else the first. */
  get chosen(): Picture {
    return this.#store.state.document?.picture ?? this.offered[0]!;
  }

  /** Takes pictures of the person's own; the last one is put on. */
  async add(files: readonly File[]): Promise<void> {
    for (const file of files) {
      try {
        const picture = ownPicture(file.name, await readPicture(file));
        picture.read(); // refuses what cannot be used
        this.#store.set({ pictures: [...this.#store.state.pictures, picture] });
        this.choose(picture);
      } catch (thrown) {
        this.#store.set({ notice: { tone: 'error', text: toFailure(thrown).message } });
      }
    }
  }

  /** Offers the normal map inside a file; one that cannot be read is just not there. */
  async #unpack(source: Source): Promise<void> {
    this.#source = source;
    if (!source.normalMap || this.#store.state.pictures.some(({ file }) => file === source)) return;
    const { name, bytes } = source.normalMap;
    try {
      const picture = ownPicture(name, await readPicture(new File([bytes], name)), source);
      picture.read();
      this.#store.set({ pictures: [...this.#store.state.pictures, picture] });
    } catch {}
  }
}
