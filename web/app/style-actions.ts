import type { Editor } from '../../src/editor/editor.ts';
import { freeName } from '../../src/editor/free-name.ts';
import { activeStep } from '../../src/editor/project.ts';
import { startingStep, styleParameter } from '../../src/editor/starting-step.ts';
import type { Engine } from '../../src/engine/client.ts';
import { isPng } from '../../src/inputs/images/png.ts';
import { normalsOfConvex } from '../../src/inputs/styles/convex-normals.ts';
import { mapOfCapture } from '../../src/inputs/styles/exact-capture.ts';
import { toFailure } from '../../src/mesh/failure.ts';
import type { Mesh } from '../../src/mesh/mesh.ts';
import type { MethodDescriptor } from '../../src/methods/descriptor.ts';
import { findMethod, methods } from '../../src/methods/registry.ts';
import type { GaussMap } from '../../src/methods/values/gauss-map.ts';
import type { ParameterValues } from '../../src/methods/values/index.ts';
import type { FlowListener } from '../../src/recipe/index.ts';
import { Film } from './film.ts';
import { canTake } from './offered-methods.ts';
import type { Gallery, PageStore } from './page-state.ts';
import { firstStyles, isPainted, ownStyle, type StyleAsset, type StyleEntry } from './style-gallery.ts';

export interface StyleActionsParts {
  readonly store: PageStore;
  readonly editor: Editor;
  readonly engine: Engine;
  /** Resolves when what was last set is on the screen. */
  readonly drawn: () => Promise<void>;
}

/** The parameter that takes any style. */
const anyStyle = methods.map(styleParameter).find((parameter) => parameter && !parameter.mapping)!;

/** As long as a flow to the sphere is shown, and then the sphere. */
const playMilliseconds = 1500;

/** All that can be done with styles: choose one, bring one, read it through the sphere. */
export class StyleActions {
  readonly #store: PageStore;
  readonly #editor: Editor;
  readonly #engine: Engine;
  readonly #drawn: () => Promise<void>;
  #latest = 0;

  constructor({ store, editor, engine, drawn }: StyleActionsParts) {
    this.#store = store;
    this.#editor = editor;
    this.#engine = engine;
    this.#drawn = drawn;
  }

  /** The style that the active step has or, before any was chosen, would get. */
  get chosenId(): string {
    const { project } = this.#store.state;
    const step = project && activeStep(project);
    const parameter = styleParameter(findMethod(step?.method ?? ''));
    const source = step && parameter ? step.parameters[parameter.name] : undefined;
    return this.#entry(String(source ?? firstStyles[parameter?.name ?? 'style']))?.id ?? '';
  }

  /**
   * Restyles the mesh, with the method that is on if it can take this style. The latest choice wins if an earlier one is still
   * being read.
   */
  async choose(entry: StyleEntry, watch = false): Promise<void> {
    const turn = ++this.#latest;
    this.#set({ pending: entry.id, offer: null, flow: null });
    const film = new Film();
    try {
      const map = await this.#read(entry, watch ? film.take : undefined);
      if (turn !== this.#latest) return;
      await this.#apply(entry, map, () => turn === this.#latest);
      if (watch) void this.#play(film, entry.name, turn);
    } catch (thrown) {
      if (turn === this.#latest) this.#fail(thrown);
    } finally {
      if (turn === this.#latest) this.#set({ pending: null });
    }
  }

  /** The method of that name; one that takes a style opens with the one that looks best. */
  async chooseMethod(id: string): Promise<void> {
    this.#latest++;
    const { project } = this.#store.state;
    const isRemembered = project && activeStep(project).remembered[id];
    const given = isRemembered ? {} : firstStyle(id);
    const [style] = Object.values(given);
    await this.#editor.chooseMethod(id, given, this.#entry(String(style))?.name);
  }

  /** A step with this method after the active one; if it takes a style, with the one that looks best. */
  async addStep(id: string): Promise<void> {
    this.#latest++;
    await this.#editor.addStep(id, firstStyle(id));
  }

  /** Reads all that comes with the page while nobody waits, so that the first click is as quick as the second. */
  async readAhead(): Promise<void> {
    for (const entry of this.#store.state.gallery.entries) {
      while (this.#store.state.activity.kind !== 'idle') await pause(100);
      await this.#read(entry).catch(() => {});
      await pause(0);
    }
  }

  /** Makes a style of a mesh or of a capture, and puts it on. */
  async add(bytes: Uint8Array<ArrayBuffer>, file: string): Promise<void> {
    try {
      const isImage = isPng(bytes);
      const entry = isImage ? this.#captureOf(bytes, file) : await this.#shapeOf(bytes, file);
      if (entry) await this.#enter(entry);
    } catch (thrown) {
      this.#fail(thrown);
    }
  }

  /** Lists a style that came with a recipe or a project; the ball that is painted on is none that one chooses. */
  adopt(name: string, asset: StyleAsset): void {
    if (this.#entry(name) || isPainted(name)) return;
    const group = asset.kind === 'gauss-map' ? 'captures' : isConvex(asset.mesh) ? 'shapes' : 'meshes';
    this.#list(ownStyle(group, name, asset));
  }

  /** The person's word: read what is not convex through the sphere. */
  async accept(): Promise<void> {
    const { offer } = this.#store.state.gallery;
    if (!offer) return;
    this.#list(offer.entry);
    await this.choose(offer.entry, true);
    if (this.chosenId !== offer.entry.id) this.#unlist(offer.entry);
  }

  decline(): void {
    this.#set({ offer: null });
  }

  #entry(source: string): StyleEntry | undefined {
    return this.#store.state.gallery.entries.find((entry) => entry.source === source);
  }

  /** Reads what a recipe would name; what a person brought is an asset under that name. */
  #read(entry: StyleEntry, onFlow?: FlowListener): Promise<GaussMap> {
    return this.#editor.resolver.gaussMap(anyStyle, entry.source, 'auto', onFlow);
  }

  /** Null where the mesh is to be offered another way. */
  async #shapeOf(bytes: Uint8Array<ArrayBuffer>, file: string): Promise<StyleEntry | null> {
    const { mesh } = await this.#engine.read(bytes, file);
    const asset = { kind: 'mesh', mesh, file: bytes } as const;
    if (isConvex(mesh)) return ownStyle('shapes', this.#freeName(file), asset);
    // The sphere says what is wrong with it, if anything is.
    const entry = ownStyle('meshes', this.#freeName(file), asset);
    this.#set({ offer: { entry, why: `${file} is not a convex shape with flat faces.` } });
    return null;
  }

  #captureOf(bytes: Uint8Array<ArrayBuffer>, file: string): StyleEntry {
    const map = mapOfCapture(bytes, file);
    return ownStyle('captures', this.#freeName(file), { kind: 'gauss-map', map, file: bytes });
  }

  #freeName(file: string): string {
    return freeName(file, (name) => this.#entry(name) !== undefined);
  }

  async #enter(entry: StyleEntry): Promise<void> {
    this.#list(entry);
    this.#set({ offer: null });
    await this.choose(entry);
  }

  #list(entry: StyleEntry): void {
    this.#set({ entries: [...this.#store.state.gallery.entries, entry] });
  }

  #unlist(entry: StyleEntry): void {
    this.#set({ entries: this.#store.state.gallery.entries.filter((one) => one !== entry) });
  }

  async #apply({ source, name, asset }: StyleEntry, map: GaussMap, isLatest: () => boolean): Promise<void> {
    const { project } = this.#store.state;
    const step = project && activeStep(project);
    const wanted = findMethod(step?.method ?? '');
    const method = canTake(wanted, map) ? wanted : methods.find((one) => canTake(one, map));
    const parameter = styleParameter(method);
    if (!project || !step || !method || !parameter) return;
    const { resolver } = this.#editor;
    const starting = await startingStep(method, { [parameter.name]: source }, project, resolver);
    const present = step.method === method.id ? step.parameters : step.remembered[method.id];
    const parameters = present
      ? await this.#carriedOver(method, present, starting.parameters)
      : starting.parameters;
    const assets = asset ? { assets: new Map([[source, asset]]) } : {};
    if (isLatest()) this.#editor.restyle({ method: method.id, parameters, ...assets }, name);
  }

  /** What the person chose stays; what nobody touched becomes what suits the new style. */
  async #carriedOver(
    method: MethodDescriptor,
    present: ParameterValues,
    after: ParameterValues,
  ): Promise<ParameterValues> {
    const { name } = styleParameter(method)!;
    const given = present[name] === undefined ? {} : { [name]: present[name] };
    const project = this.#store.state.project!;
    const { parameters: before } = await startingStep(method, given, project, this.#editor.resolver);
    const touched = Object.entries(present).filter(([key, value]) => key !== name && value !== before[key]);
    return { ...after, ...Object.fromEntries(touched) };
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

/** What a method that takes a style opens with. */
function firstStyle(id: string): ParameterValues {
  const parameter = styleParameter(findMethod(id));
  const first = parameter && firstStyles[parameter.name];
  return parameter && first ? { [parameter.name]: first } : {};
}

/** Whether a shape's faces alone tell its style. */
function isConvex(mesh: Mesh): boolean {
  try {
    normalsOfConvex(mesh);
    return true;
  } catch {
    return false;
  }
}

function pause(milliseconds: number): Promise<void> {
  return new Promise((resolve) => setTimeout(resolve, milliseconds));
}
