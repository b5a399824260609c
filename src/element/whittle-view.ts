import { html, LitElement, nothing, type PropertyValues } from 'lit';
import { Editor } from '../editor/editor.ts';
import type { ReadFile } from '../editor/open-file.ts';
import { Presenter } from '../editor/presenter.ts';
import { activeStep, shownResult } from '../editor/project.ts';
import { type EditorState, emptyState, Store } from '../editor/state.ts';
import type { Engine } from '../engine/client.ts';
import type { WorkerPlace } from '../engine/start-worker.ts';
import { type Format, formatInfo, isFormat } from '../io/index.ts';
import { toFailure } from '../mesh/failure.ts';
import { findMethod } from '../methods/registry.ts';
import type { NumberParameter } from '../methods/values/number.ts';
import { beginningOf, mainNumber, type Wish } from './beginning.ts';
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
  declare failure: string | null;
  declare isShown: boolean;

  readonly #store = new Store<EditorState>(emptyState);
  #screen: ElementScreen | null = null;
  #place: WorkerPlace | null = null;
  #engine: Engine | null = null;
  #editor: Editor | null = null;
  #file: ReadFile | null = null;
  #loading: AbortController | null = null;
  #sight: IntersectionObserver | null = null;
  #wasNear = false;
  #told: unknown = null;

  constructor() {
    super();
    this.src = this.alt = this.poster = this.method = this.styleSrc = this.recipe = null;
    this.loading = this.touchAction = this.workerUrl = this.wasmUrl = this.failure = null;
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
    if (this.hasUpdated) void this.#load();
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.#sight?.disconnect();
    this.#loading?.abort();
    this.#screen?.dispose();
    this.#editor?.dispose();
    if (this.#place) releaseEngine(this.#place);
    this.#screen = this.#place = this.#engine = this.#editor = this.#file = this.#sight = null;
    this.#store.set(emptyState);
    this.#wasNear = this.isShown = false;
  }

  /** Solves again what the attributes say. Resolves when it has ended, however it ended. */
  async run(): Promise<void> {
    if (!this.#file) return this.#load();
    this.failure = null;
    try {
      const begin = await beginningOf(this.#wish, this.baseURI);
      if (begin && this.#file) await this.#editor?.openRead(this.#file, begin);
    } catch (thrown) {
      this.#fail(thrown);
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
    if (!this.#store.state.project) {
      const { positions } = file.mesh;
      return new Blob([await this.#engine!.write(file.bytes, file.name, chosen, positions)]);
    }
    const written = await this.#editor!.write(chosen);
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
    if (this.loading === 'eager') this.#see(true);
  }

  protected override updated(changed: PropertyValues): void {
    this.#screen?.describe(this.alt ?? '', this.touchAction ?? 'pan-y');
    const controls = this.renderRoot.querySelector<HTMLElement>('.controls');
    this.#screen?.setCovered(controls ? controls.offsetHeight + 8 : 0);
    if (!this.#wasNear) return;
    if (['src', 'workerUrl', 'wasmUrl'].some((name) => changed.has(name))) void this.#load();
    else if (['method', 'styleSrc', 'recipe', 'lambda'].some((name) => changed.has(name))) void this.run();
  }

  protected override render() {
    return html`
      <div class="stage" part="stage"></div>
      ${this.isShown || this.failure ? nothing : html`<slot name="poster">${this.poster ? html`<img class="poster" part="poster" src=${this.poster} alt=${this.alt ?? ''} />` : nothing}</slot>`}
      ${this.#busy()}
      ${this.failure ? html`<div class="error" part="error" role="alert"><slot name="error"><p>${this.failure}</p><button type="button" @click=${() => void this.run()}>Try again</button></slot></div>` : nothing}
      ${this.controls && this.isShown ? this.#controls() : nothing}
    `;
  }

  #busy() {
    const { activity } = this.#store.state;
    if (activity.kind === 'idle') return nothing;
    return html`<div class="progress" part="progress"><slot name="progress"><span class="bar"></span></slot></div>`;
  }

  #controls() {
    const { project, activity } = this.#store.state;
    const step = project && activeStep(project);
    const number = mainNumber(step?.method);
    return html`
      <div class="controls" part="controls">
        ${step && number ? this.#slider(number, Number(step.parameters[number.name])) : nothing}
        ${activity.kind === 'solving' ? html`<button type="button" @click=${() => this.cancel()}>Stop</button>` : nothing}
        <button type="button" @click=${() => void this.reset()}>Reset</button>
      </div>`;
  }

  #slider({ name, label, slider, min, max }: NumberParameter, value: number) {
    const set = (event: Event, phase: 'preview' | 'commit') => {
      const project = this.#store.state.project;
      if (!project) return;
      const number = (event.target as HTMLInputElement).valueAsNumber;
      const parameters = { ...activeStep(project).parameters, [name]: number };
      if (phase === 'preview') this.#editor?.preview({ parameters });
      else this.#editor?.commit({ parameters }, label);
    };
    return html`<label><span>${label}</span><input type="range" min=${slider?.min ?? min} max=${slider?.max ?? max} step=${slider?.step ?? 'any'} .value=${String(value)} @input=${(event: Event) => set(event, 'preview')} @change=${(event: Event) => set(event, 'commit')} /></label>`;
  }

  get #wish(): Wish {
    const { method, styleSrc, recipe, lambda } = this;
    return { method, styleSrc, recipe, lambda };
  }

  #see(isNear: boolean): void {
    if (isNear && !this.#wasNear) {
      this.#wasNear = true;
      void this.#load();
    } else if (isNear) this.#screen?.open();
    else this.#screen?.close();
  }

  async #load(): Promise<void> {
    this.#loading?.abort();
    this.#file = null;
    this.failure = null;
    this.isShown = false;
    this.#store.set(emptyState);
    if (!this.src || !this.#wasNear) return;
    const loading = new AbortController();
    this.#loading = loading;
    try {
      const engine = this.#open();
      const name = nameOf(this.src);
      const bytes = await fetchBytes(new URL(this.src, this.baseURI), loading.signal, (share) =>
        this.#tell('progress', { phase: 'download', share }),
      );
      const read = await engine.read(bytes, name, { signal: loading.signal });
      if (loading.signal.aborted) return;
      this.#file = { bytes, name, ...read };
      this.#screen!.show(read.mesh, formatInfo(read.format).up);
      this.isShown = true;
      const { positions, triangles } = read.mesh;
      this.#tell('load', {
        positions: positions.length / 3,
        faces: triangles.length / 3,
        format: read.format,
      });
      await this.run();
    } catch (thrown) {
      if (!loading.signal.aborted) this.#fail(thrown);
    }
  }

  /** The engine that the attributes name, and an editor on it. */
  #open(): Engine {
    const place = { workerUrl: this.workerUrl ?? workerBeside, wasmUrl: this.wasmUrl ?? undefined };
    this.#editor?.dispose();
    if (this.#place) releaseEngine(this.#place);
    this.#place = place;
    this.#engine = takeEngine(place);
    this.#screen ??= new ElementScreen(this.renderRoot.querySelector('.stage')!, (thrown) =>
      this.#fail(thrown),
    );
    this.#screen.describe(this.alt ?? '', this.touchAction ?? 'pan-y');
    const presenter = new Presenter(this.#screen, {
      drawn: () => new Promise((resolve) => requestAnimationFrame(() => resolve())),
    });
    const readFile = (name: string) => fetchBytes(new URL(name, this.baseURI));
    const surroundings = { readFile };
    this.#editor = new Editor({ store: this.#store, engine: this.#engine, presenter, surroundings });
    return this.#engine;
  }

  #follow({ project, activity, notice }: EditorState): void {
    this.requestUpdate();
    if (activity.kind === 'solving') {
      const { preparing, iteration } = activity;
      this.#tell('progress', preparing ? { phase: 'prepare', ...preparing } : { phase: 'solve', iteration });
    }
    if (notice?.tone === 'error' && notice.text !== this.failure) this.#fail(new Error(notice.text));
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
    this.failure = thrown instanceof Error && code === 'internal' ? thrown.message : message;
    this.#tell('error', { code, message: this.failure });
  }

  #tell<Name extends keyof ViewEventMap>(name: Name, detail: ViewEventMap[Name]['detail']): void {
    this.dispatchEvent(new CustomEvent(name, { detail }));
  }
}
