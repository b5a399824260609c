import type { Editor } from '../../src/editor/editor.ts';
import { freeName } from '../../src/editor/free-name.ts';
import { activeStep, type Project, type Source } from '../../src/editor/project.ts';
import { imageParameter, startingStep } from '../../src/editor/starting-step.ts';
import { layTexture } from '../../src/inputs/images/lay.ts';
import { toFailure } from '../../src/mesh/failure.ts';
import { findMethod, methods } from '../../src/methods/registry.ts';
import type { ParameterValues } from '../../src/methods/values/index.ts';
import type { FoundFile } from './found-files.ts';
import { embeddedImage, type ImageAsset, type ImageEntry, ownImage } from './image-gallery.ts';
import type { PageStore } from './page-state.ts';
import { readImage } from './read-image.ts';

/** All that can be done with images: choose one, bring one. */
export class ImageActions {
  readonly #store: PageStore;
  readonly #editor: Editor;
  /** The source whose normal map was unpacked last. */
  #source: Source | null = null;

  constructor(store: PageStore, editor: Editor) {
    this.#store = store;
    this.#editor = editor;
    store.subscribe(({ project }) => {
      if (project && project.source !== this.#source) void this.#unpack(project.source);
    });
  }

  /** Those that can be laid on the mesh: a file's own normal map first, and on no other mesh. */
  get offered(): readonly ImageEntry[] {
    const { images, project } = this.#store.state;
    const own = images.filter(({ file }) => file && file === project?.source);
    return [...own, ...images.filter(({ file }) => !file)];
  }

  /** The image that the active step has, or would get: the first that is offered. */
  get chosen(): ImageEntry {
    const { project } = this.#store.state;
    const source = project && imageOf(project);
    return this.offered.find((entry) => entry.source === source) ?? this.offered[0]!;
  }

  /** What a person should know of the image on the mesh; undefined if there is nothing, or if the run has said that it fails. */
  get remark(): string | undefined {
    const { project } = this.#store.state;
    if (!project) return undefined;
    const { reading, green, repeat } = activeStep(project).parameters as Parameters<
      ImageEntry['texture']
    >[0] & {
      repeat?: number;
    };
    try {
      return layTexture(this.chosen.texture({ reading, green }), project.mesh, { repeat }).remark;
    } catch {
      return undefined;
    }
  }

  /** Lays an image on the mesh and makes shape of it. */
  async choose(entry: ImageEntry): Promise<void> {
    const { project } = this.#store.state;
    const method = methods.find((one) => imageParameter(one) !== undefined);
    if (!project || !method) return;
    const { source, asset, name } = entry;
    const given: ParameterValues = source === undefined ? {} : { [imageParameter(method)!]: source };
    const starting = await startingStep(method, given, project, this.#editor.resolver);
    if (this.#store.state.project?.mesh !== project.mesh) return;
    const assets = asset && source !== undefined ? new Map([[source, asset]]) : undefined;
    const parameters = { ...starting.parameters, ...this.#kept(project, method.id), ...given };
    if (source === undefined) delete (parameters as Record<string, unknown>)[imageParameter(method)!];
    const repeat = starting.parameters.repeat!;
    this.#editor.restyle(
      { method: method.id, parameters: { ...parameters, repeat }, ...(assets ? { assets } : {}) },
      name,
    );
  }

  /** Takes images of the person's own; the last one is put on. */
  async add(files: readonly FoundFile[]): Promise<void> {
    for (const file of files) {
      try {
        const bytes = new Uint8Array(await file.arrayBuffer());
        const image = await readImage(bytes, file.name);
        const source = freeName(file.name, (name) => this.#isTaken(name));
        const entry = ownImage(source, { kind: 'image', image, file: bytes });
        entry.texture(); // refuses what cannot be used
        this.#list(entry);
        await this.choose(entry);
      } catch (thrown) {
        this.#store.set({ notice: { tone: 'error', text: toFailure(thrown).message } });
      }
    }
  }

  /** Lists an image that came with a recipe or a project. */
  adopt(name: string, asset: ImageAsset): void {
    if (!this.#isTaken(name)) this.#list(ownImage(name, asset));
  }

  /** What the person set stays, but for how this very image is read and how often it comes. */
  #kept(project: Project, method: string): ParameterValues {
    const step = activeStep(project);
    const { reading, green, ...kept } =
      (step.method === method ? step.parameters : step.remembered[method]) ?? {};
    return kept;
  }

  #isTaken(name: string): boolean {
    return this.#store.state.images.some(({ source }) => source === name);
  }

  #list(entry: ImageEntry): void {
    this.#store.set({ images: [...this.#store.state.images, entry] });
  }

  /** Offers the normal map inside a file; one that cannot be read is just not there. */
  async #unpack(source: Source): Promise<void> {
    this.#source = source;
    if (!source.normalMap || this.#store.state.images.some(({ file }) => file === source)) return;
    const { name, bytes } = source.normalMap;
    try {
      const entry = embeddedImage(name, await readImage(bytes, name), source);
      entry.texture();
      this.#list(entry);
    } catch {}
  }
}

/** What the active step says of its image; undefined for the one inside the file. */
function imageOf(project: Project): unknown {
  const { method, parameters } = activeStep(project);
  const name = imageParameter(findMethod(method));
  return name === undefined ? undefined : parameters[name];
}
