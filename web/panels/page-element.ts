import { LitElement } from 'lit';
import type { Page } from '../app/actions.ts';
import type { PageState } from '../app/page-state.ts';

/** A panel: drawn from the page's state into the document itself, so that one style sheet and one focus order serve all. */
export abstract class PageElement extends LitElement {
  #page: Page | null = null;
  #unsubscribe: (() => void) | null = null;

  get page(): Page {
    return this.#page!;
  }

  set page(page: Page) {
    if (page === this.#page) return;
    this.#page = page;
    this.#listen();
    this.requestUpdate();
  }

  override connectedCallback(): void {
    super.connectedCallback();
    this.#listen();
    this.requestUpdate();
  }

  /** What has left the page hears no more of it. */
  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.#unsubscribe?.();
    this.#unsubscribe = null;
  }

  get state(): PageState {
    return this.page.store.state;
  }

  protected stateChanged(_state: PageState): void {}

  protected override createRenderRoot(): this {
    return this;
  }

  protected override shouldUpdate(): boolean {
    return this.#page !== null && this.isConnected;
  }

  #listen(): void {
    this.#unsubscribe?.();
    this.#unsubscribe =
      this.#page?.store.subscribe((state) => {
        this.stateChanged(state);
        this.requestUpdate();
      }) ?? null;
  }
}
