import type { Workspace } from '../../src/editor/editor.ts';
import type { ChosenStyle, WhittleDocument } from '../../src/editor/project.ts';
import type { Engine } from '../../src/engine/client.ts';
import { isPng, readPng } from '../../src/inputs/images/png.ts';
import { mapOfPixels } from '../../src/inputs/styles/captures.ts';
import { normalsOfConvex } from '../../src/inputs/styles/convex-normals.ts';
import { toFailure } from '../../src/mesh/failure.ts';
import type { MethodDescriptor } from '../../src/methods/descriptor.ts';
import { findMethod, methods } from '../../src/methods/registry.ts';
import type { ParameterValues } from '../../src/methods/values/index.ts';
import { Film, StyleReader } from './film.ts';
import { canTake, startingParameters, styleOf, styleParameter } from './offered-methods.ts';
import type { Gallery, Store } from './store.ts';
import { firstDirections, firstStyle, ownStyle, type StyleEntry } from './style-gallery.ts';

export interface StyleDeskParts {
  readonly store: Store;
  readonly workspace: Workspace;
  readonly engine: Engine;
  /** Resolves when what was last set is on the screen. */
  readonly drawn: () => Promise<void>;
}

/** As long as a flow to the sphere is shown, and then the sphere. */
const playMilliseconds = 1500;

/** All that can be done with styles: choose one, bring one, read it through the sphere. */
export class StyleDesk {
  readonly #store: Store;
  readonly #workspace: Workspace;
  readonly #engine: Engine;
  readonly #reader: StyleReader;
  readonly #drawn: () => Promise<void>;
  #latest = 0;

  constructor({ store, workspace, engine, drawn }: StyleDeskParts) {
    this.#store = store;
    this.#workspace = workspace;
    this.#engine = engine;
    this.#drawn = drawn;
    this.#reader = new StyleReader(engine);
  }

  /** The style that the document has or, before any was chosen, would get. */
  get chosenId(): string {
    const { document } = this.#store.state;
    const style = document && styleOf(document);
    return style?.id ?? firstEntry(findMethod(document?.method ?? '')).id;
  }

  /**
   * Restyles the mesh, with the method that is on if it can take this style. The latest choice wins if an earlier one is still
   * being read.
   */
  async choose(entry: StyleEntry, watch = false, methodId?: string): Promise<void> {
    const turn = ++this.#latest;
    this.#set({ pending: entry.id, offer: null, flow: null });
    const film = new Film();
    try {
      const map = await this.#reader.read(entry, watch ? film.take : undefined);
      if (turn !== this.#latest) return;
      this.#apply({ id: entry.id, name: entry.name, source: entry.source, map }, methodId);
      if (watch) void this.#play(film, entry.name, turn);
    } catch (thrown) {
      if (turn === this.#latest) this.#fail(thrown);
    } finally {
      if (turn === this.#latest) this.#set({ pending: null });
    }
  }

  /** The method of that name; one that takes a style gets the one that was chosen last. */
  async chooseMethod(id: string): Promise<void> {
    const method = findMethod(id);
    const parameter = styleParameter(method);
    const { document } = this.#store.state;
    if (!parameter || document?.[parameter.name]) this.#workspace.chooseMethod(id);
    else await this.choose(firstEntry(method), false, id);
  }

  /** Reads all that comes with the page while nobody waits, so that the first click is as quick as the second. */
  async readAhead(): Promise<void> {
    for (const entry of this.#store.state.gallery.entries) {
      while (this.#store.state.activity.kind !== 'idle') await pause(100);
      await this.#reader.read(entry).catch(() => {});
      await pause(0);
    }
  }

  /** Makes a style of a mesh or of a capture, and puts it on. */
  async add(bytes: Uint8Array<ArrayBuffer>, file: string): Promise<void> {
    try {
      const isPicture = isPng(bytes);
      const entry = isPicture ? captureOf(bytes, file) : await this.#shapeOf(bytes, file);
      if (entry) await this.#enter(entry);
    } catch (thrown) {
      this.#fail(thrown);
    }
  }

  /** The person's word: read what is not convex through the sphere. */
  async accept(): Promise<void> {
    const { offer } = this.#store.state.gallery;
    if (!offer) return;
    const { entries } = this.#store.state.gallery;
    await this.choose(offer.entry, true);
    if (this.chosenId === offer.entry.id) this.#set({ entries: [...entries, offer.entry] });
  }

  decline(): void {
    this.#set({ offer: null });
  }

  /** Null where the mesh is to be offered another way. */
  async #shapeOf(bytes: Uint8Array<ArrayBuffer>, file: string): Promise<StyleEntry | null> {
    const { mesh } = await this.#engine.read(bytes, file);
    try {
      normalsOfConvex(mesh);
    } catch {
      // The sphere says what is wrong with it, if anything is.
      this.#set({
        offer: {
          entry: ownStyle('meshes', file, () => ({ mesh })),
          why: `${file} is not a convex shape with flat faces.`,
        },
      });
      return null;
    }
    return ownStyle('shapes', file, () => ({ mesh }));
  }

  async #enter(entry: StyleEntry): Promise<void> {
    this.#set({ entries: [...this.#store.state.gallery.entries, entry], offer: null });
    await this.choose(entry);
  }

  #apply(style: ChosenStyle, methodId?: string): void {
    const { document } = this.#store.state;
    const wanted = findMethod(methodId ?? document?.method ?? '');
    const method = canTake(wanted, style.map) ? wanted : methods.find((one) => canTake(one, style.map));
    const parameter = styleParameter(method);
    if (!document || !method || !parameter) return;
    const parameters =
      document.method === method.id
        ? carriedOver(method, document, style)
        : startingParameters(method, { ...document, style });
    this.#workspace.restyle({ method: method.id, parameters, [parameter.name]: style }, style.name);
  }

  /** Shows a flow that is over too soon to be seen; another choice ends it. */
  async #play(film: Film, name: string, turn: number): Promise<void> {
    const began = performance.now();
    for (let share = 0; share < 1 && turn === this.#latest; ) {
      share = Math.min(1, (performance.now() - began) / playMilliseconds);
      const picture = film.at(share);
      if (picture) this.#set({ flow: { name, ...picture } });
      await this.#drawn();
      await pause(30);
    }
    await pause(playMilliseconds);
    if (turn === this.#latest) this.#set({ flow: null });
  }

  #set(change: Partial<Gallery>): void {
    this.#store.set({ gallery: { ...this.#store.state.gallery, ...change } });
  }

  #fail(thrown: unknown): void {
    this.#store.set({ notice: { tone: 'error', text: toFailure(thrown).message } });
  }
}

function firstEntry(method: MethodDescriptor | undefined): StyleEntry {
  return styleParameter(method)?.name === 'directions' ? firstDirections : firstStyle;
}

/** What the person chose stays; what nobody touched becomes what suits the new style. */
function carriedOver(
  method: MethodDescriptor,
  document: WhittleDocument,
  style: ChosenStyle,
): ParameterValues {
  const before = startingParameters(method, document);
  const after = startingParameters(method, { ...document, style });
  const touched = Object.entries(document.parameters).filter(([name, value]) => value !== before[name]);
  return { ...after, ...Object.fromEntries(touched) };
}

function captureOf(bytes: Uint8Array, file: string): StyleEntry {
  const map = mapOfPixels(readPng(bytes, file));
  return ownStyle('captures', file, () => ({ map }));
}

function pause(milliseconds: number): Promise<void> {
  return new Promise((resolve) => setTimeout(resolve, milliseconds));
}
