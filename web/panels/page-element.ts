import { LitElement } from 'lit';
import type { State } from '../document/store.ts';
import type { Page } from '../tools/page.ts';

/** A panel: drawn from the page's state into the document itself, so that one style sheet and one focus order serve all. */
export abstract class PageElement extends LitElement {
  #page: Page | null = null;
  #unsubscribe: (() => void) | null = null;

  get page(): Page {
    return this.#page!;
  }

  set page(page: Page) {
    this.#unsubscribe?.();
    this.#page = page;
    this.#unsubscribe = page.store.subscribe((state) => {
      this.stateChanged(state);
      this.requestUpdate();
    });
    this.requestUpdate();
  }

  get state(): State {
    return this.page.store.state;
  }

  protected stateChanged(_state: State): void {}

  protected override createRenderRoot(): this {
    return this;
  }

  protected override shouldUpdate(): boolean {
    return this.#page !== null;
  }
}
