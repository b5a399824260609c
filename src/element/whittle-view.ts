import { html, LitElement, nothing, type PropertyValues } from 'lit';
import { Editor } from '../editor/editor.ts';
import { emptyHistory } from '../editor/history.ts';
import type { ReadFile } from '../editor/open-file.ts';
import { Presenter } from '../editor/presenter.ts';
import { shownResult } from '../editor/project.ts';
import { type EditorState, emptyState, Store } from '../editor/state.ts';
import type { Engine } from '../engine/client.ts';
import { gatherBeside } from '../engine/gather.ts';
import type { WorkerPlace } from '../engine/start-worker.ts';
import { type Format, formatInfo, isFormat } from '../io/index.ts';
import { toFailure, WhittleError } from '../mesh/failure.ts';
import { findMethod } from '../methods/registry.ts';
import { baseOf, beginningOf, type Wish } from './beginning.ts';
import { type ControlActs, controls } from './controls.ts';
import type { ViewEventMap } from './events.ts';
import { fetchBytes, nameOf } from './fetch-bytes.ts';
import { ElementScreen } from './screen.ts';
import { releaseEngine, takeEngine } from './shared-engine.ts';
import { styles } from './styles.ts';

/** The worker's script that ships beside the element's. */
const workerBeside = new URL(/* @vite-ignore */ './whittle-worker.js', import.meta.url).href;

/**
 * `<whittle-view src="rabbit.glb" method="cubic" lambda="0.3" alt="A rabbit carved into a cube" controls>`: a mesh on any page, shaped
 * by a method or a recipe. The plain mesh, or the poster, is there first; the core is fetched when there is something to solve.
 *
 * Events: `load`, `progress`, `change`, `error` (see {@link ViewEventMap}). Slots: `poster`, `progress`, `error`. Parts: `stage`,
 * `canvas`, `poster`, `progress`, `error`, `controls`.
 */
export class WhittleView extends LitElement {
  /** The rules of its shadow root. */
  static override styles = styles;
  /** Properties that are attributes too, and what it redraws for. */
  static override properties = {
    src: { reflect: true },
    alt: { reflect: true },
    poster: { reflect: true },
    method: { reflect: true },
    styleSrc: { reflect: true, attribute: 'style-src' },
    recipe: { reflect: true },
    lambda: { reflect: true, type: Number },
    controls: { reflect: true, type: Boolean },
    loading: { reflect: true },
    touchAction: { reflect: true, attribute: 'touch-action' },
    workerUrl: { reflect: true, attribute: 'worker-url' },
    wasmUrl: { reflect: true, attribute: 'wasm-url' },
    failure: { state: true },
    blindness: { state: true },
    isShown: { state: true },
  };
  /** The mesh file's address. */
  declare src: string | null;
  /** What the picture is of, in words. */
  declare alt: string | null;
  /** An image that is shown until the mesh is there. */
  declare poster: string | null;
  /** A method of ours; without one, and without a recipe, the mesh stays as it is. */
  declare method: string | null;
  /** For methods that take a style or an image: a name of ours, or the address of a file. */
  declare styleSrc: string | null;
  /** A recipe as JSON text, or its address; it comes before {@link method}. */
  declare recipe: string | null;
  /** The method's strength; default what suits the mesh. */
  declare lambda: number | null;
  /** Shows a slider for the strength and a way back. */
  declare controls: boolean;
  /** `lazy` (the default) waits until the element comes near the screen. */
  declare loading: 'lazy' | 'eager' | null;
  /** Touch gestures that stay the page's, as in CSS; default `pan-y`. */
  declare touchAction: string | null;
  declare workerUrl: string | null;
  declare wasmUrl: string | null;
  /** What went wrong last, until something else is tried. */
  declare failure: string | null;
  /** Why nothing can be drawn here. */
  declare blindness: string | null;
  /** The mesh has taken the poster's place. */
  declare isShown: boolean;

  readonly #store = new Store<EditorState>(emptyState);
  #screen: ElementScreen | null = null;
  #place: WorkerPlace | null = null;
  #engine: Engine | null = null;
  #editor: Editor | null = null;
  /** What the names in the editor's recipe are relative to. */
  #base = '';
  #file: ReadFile | null = null;
  #loading: AbortController | null = null;
  #sight: IntersectionObserver | null = null;
  #isNear = false;
  /** The element has been near the screen, or was to be loaded at once. */
  #isWanted = false;
  #latestRun = 0;
  #told: unknown = null;

  constructor() {
    super();
    this.src = this.alt = this.poster = this.method = this.styleSrc = this.recipe = null;
    this.loading = this.touchAction = this.workerUrl = this.wasmUrl = this.failure = this.blindness = null;
    this.lambda = null;
    this.controls = this.isShown = false;
    this.#store.subscribe((state) => this.#follow(state));
  }

  override connectedCallback(): void {
    super.connectedCallback();
    this.#sight = new IntersectionObserver((entries) => this.#see(entries.at(-1)!.isIntersecting), {
      rootMargin: '200px',
    });
    this.#sight.observe(this);
    if (this.hasUpdated) this.#loadEagerly();
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.#sight?.disconnect();
    this.#leave();
    this.#clear();
    if (this.#place) releaseEngine(this.#place);
    this.#place = this.#engine = this.#sight = null;
    this.#isWanted = this.#isNear = false;
  }

  /** Solves again what the attributes say. Resolves when it has ended, however it ended. */
  async run(): Promise<void> {
    const file = this.#file;
    if (!file) return this.#load();
    const turn = ++this.#latestRun;
    this.failure = null;
    try {
      const begin = await beginningOf(this.#wish, this.baseURI);
      if (turn !== this.#latestRun) return;
      if (!begin) return this.#showPlain(file);
      const editor = this.#edit(baseOf(this.#wish, this.baseURI));
      // Nobody can undo here.
      this.#store.set({ history: emptyHistory });
      await editor.openRead(file, begin);
    } catch (thrown) {
      if (turn === this.#latestRun) this.#fail(thrown);
    }
  }

  /** Stops what is running; the shape on the screen stays. */
  cancel(): void {
    this.#editor?.cancel();
  }

  /** Back to what the attributes say, and to the first view. */
  reset(): Promise<void> {
    this.#screen?.fit();
    return this.run();
  }

  /**
   * The mesh file with the settled shape.
   *
   * @param format default the one that it came in
   * @throws Error if there is no mesh yet, or if it could not be written
   */
  async toBlob(format?: Format): Promise<Blob> {
    const file = this.#file;
    if (!file) throw new Error('There is no mesh yet; wait for the event “load”.');
    if (format !== undefined && !isFormat(format)) throw new Error(`There is no format “${format}”.`);
    const chosen = format ?? formatInfo(file.format).id;
    if (!this.#editor || !this.#store.state.project) {
      const { positions } = file.mesh;
      const { bytes, name, beside } = file;
      return new Blob([(await this.#engine!.write(bytes, name, chosen, positions, { beside })).bytes]);
    }
    const written = await this.#editor.write(chosen);
    if (!written) throw new Error(this.#store.state.notice?.text ?? 'The file could not be written.');
    return new Blob([written.bytes]);
  }

  /** What is on the screen, as the address of a PNG that needs no network. */
  async toDataURL(): Promise<string> {
    if (!this.#screen) throw new Error('There is no picture yet; wait for the event “load”.');
    const picture = await this.#screen.snapshot();
    return new Promise((resolve, reject) => {
      const reader = new FileReader();
      reader.onload = () => resolve(reader.result as string);
      reader.onerror = () => reject(reader.error);
      reader.readAsDataURL(picture);
    });
  }

  protected override firstUpdated(): void {
    this.#loadEagerly();
  }

  protected override updated(changed: PropertyValues): void {
    this.#screen?.describe(this.#label, this.touchAction ?? 'pan-y');
    const bar = this.renderRoot.querySelector<HTMLElement>('.controls');
    this.#screen?.setCovered(bar ? bar.offsetHeight + 8 : 0);
    if (!this.#isWanted) this.#loadEagerly();
    else if (['src', 'workerUrl', 'wasmUrl'].some((name) => changed.has(name))) void this.#load();
    else if (['method', 'styleSrc', 'recipe', 'lambda'].some((name) => changed.has(name))) void this.run();
  }

  protected override render() {
    return html`
      <div class="stage" part="stage"></div>
      ${this.isShown && !this.blindness ? nothing : html`<slot name="poster">${this.poster ? html`<img class="poster" part="poster" src=${this.poster} alt=${this.#label} />` : nothing}</slot>`}
      ${this.#busy()}
      ${this.#wrong()}
      ${this.controls && this.isShown ? controls(this.#store.state, this.#acts) : nothing}
    `;
  }

  #wrong() {
    const text = this.failure ?? this.blindness;
    if (!text) return nothing;
    const again = html`<button type="button" @click=${() => void this.run()}>Try again</button>`;
    return html`<div class="error" part="error" role="alert"><slot name="error"><p>${text}</p>${this.failure ? again : nothing}</slot></div>`;
  }

  #busy() {
    const { activity } = this.#store.state;
    if (activity.kind === 'idle') return nothing;
    return html`<div class="progress" part="progress" role="progressbar" aria-label="Loading and shaping"><slot name="progress"><span class="bar"></span></slot></div>`;
  }

  readonly #acts: ControlActs = {
    preview: (change) => this.#editor?.preview(change),
    commit: (change, label) => this.#editor?.commit(change, label),
    stop: () => this.cancel(),
    reset: () => void this.reset(),
  };

  get #wish(): Wish {
    const { method, styleSrc, recipe, lambda } = this;
    return { method, styleSrc, recipe, lambda };
  }

  /** The picture in words; where the page has none for it, the file's name. */
  get #label(): string {
    return this.alt ?? nameOf(this.src ?? '');
  }

  #see(isNear: boolean): void {
    this.#isNear = isNear;
    if (!isNear) this.#screen?.close();
    else if (this.#isWanted) this.#screen?.open();
    else this.#want();
  }

  #loadEagerly(): void {
    if (this.loading === 'eager' && !this.#isWanted && this.isConnected) this.#want();
  }

  #want(): void {
    this.#isWanted = true;
    void this.#load();
  }

  async #load(): Promise<void> {
    this.#leave();
    if (!this.src) this.#clear();
    if (!this.src || !this.#isWanted) return;
    const loading = new AbortController();
    this.#loading = loading;
    try {
      const engine = this.#open();
      const name = nameOf(this.src);
      const address = new URL(this.src, this.baseURI);
      const bytes = await fetchBytes(address, loading.signal, (share) =>
        this.#tell('progress', { phase: 'download', share }),
      );
      const beside = await gatherBeside(engine, bytes, name, {
        signal: loading.signal,
        read: (path) => fetchBytes(new URL(encodeURI(path), address), loading.signal).catch(() => undefined),
        wanted: ({ isShape }) => isShape,
      });
      const read = await engine.read(bytes, name, { signal: loading.signal, beside });
      if (loading.signal.aborted) return;
      this.#file = { bytes, name, beside, ...read };
      this.#showPlain(this.#file);
      this.isShown = true;
      const { positions, triangles } = read.mesh;
      this.#tell('load', {
        positions: positions.length / 3,
        faces: triangles.length / 3,
        format: read.format,
      });
      if (!loading.signal.aborted) await this.run();
    } catch (thrown) {
      if (!loading.signal.aborted) this.#fail(thrown);
    }
  }

  /** Ends all that is under way with a mesh. Its picture stays until there is another. */
  #leave(): void {
    this.#loading?.abort();
    this.#editor?.dispose();
    this.#latestRun++;
    this.#editor = this.#file = null;
    this.failure = null;
    this.isShown = false;
    this.#store.set(emptyState);
  }

  #clear(): void {
    this.#screen?.dispose();
    this.#screen = null;
    this.blindness = null;
  }

  #showPlain({ mesh, format }: ReadFile): void {
    this.#editor?.dispose();
    this.#editor = null;
    this.#store.set(emptyState);
    this.#screen?.show(mesh, formatInfo(format).up);
  }

  /** The engine that the attributes name, and a screen. */
  #open(): Engine {
    const place = { workerUrl: this.workerUrl ?? workerBeside, wasmUrl: this.wasmUrl ?? undefined };
    const before = this.#place;
    this.#engine = takeEngine(place);
    // Taken before the old one is given back: where they are the same its worker goes on.
    if (before) releaseEngine(before);
    this.#place = place;
    this.#screen ??= new ElementScreen(this.renderRoot.querySelector('.stage')!, (thrown) =>
      this.#goBlind(thrown),
    );
    this.#screen.describe(this.#label, this.touchAction ?? 'pan-y');
    if (this.#isNear) this.#screen.open();
    return this.#engine;
  }

  /** An editor for which the names of files are relative to an address. */
  #edit(base: string): Editor {
    if (this.#editor && base === this.#base) return this.#editor;
    this.#editor?.dispose();
    this.#base = base;
    const presenter = new Presenter(this.#screen, {
      drawn: () => new Promise((resolve) => requestAnimationFrame(() => resolve())),
    });
    const readFile = (name: string) => fetchBytes(new URL(name, base));
    this.#editor = new Editor({
      store: this.#store,
      engine: this.#engine!,
      presenter,
      surroundings: { readFile },
    });
    return this.#editor;
  }

  #follow({ project, activity, notice }: EditorState): void {
    this.requestUpdate();
    if (activity.kind === 'solving')
      this.#tell('progress', { phase: 'solve', iteration: activity.iteration });
    if (notice?.tone === 'error' && notice.text !== this.failure)
      this.#fail(new WhittleError(notice.code ?? 'internal', notice.text));
    const result = project && shownResult(project);
    if (!result || result === this.#told || result.state === 'preview') return;
    this.#told = result;
    const method = findMethod(result.of.method);
    if (method) this.#screen?.setShading(method.shading);
    const { outcome, iterations, state } = result;
    this.#tell('change', { method: result.of.method, outcome, iterations, state });
  }

  #fail(thrown: unknown): void {
    const { code, message } = toFailure(thrown);
    this.failure = message;
    this.#tell('error', { code, message });
  }

  #goBlind(thrown: unknown): void {
    const message = thrown instanceof Error ? thrown.message : String(thrown);
    if (message === this.blindness) return;
    this.blindness = message;
    this.#tell('error', { code: 'internal', message });
  }

  #tell<Name extends keyof ViewEventMap>(name: Name, detail: ViewEventMap[Name]['detail']): void {
    this.dispatchEvent(new CustomEvent(name, { detail }));
  }
}
