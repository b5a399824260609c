import { html, LitElement, nothing, type TemplateResult } from 'lit';

export interface MenuItem {
  readonly label: string;
  readonly about?: string;
  readonly picture?: string;
  /** A line is drawn above it. */
  readonly isFirst?: boolean;
  readonly run: () => void;
}

/** A button that opens a list of things to do. Arrow keys walk, Escape and a click elsewhere close. */
export class WhittleMenu extends LitElement {
  static override properties = {
    items: { attribute: false },
    face: { attribute: false },
    label: {},
    open: { state: true },
  };
  declare items: readonly MenuItem[];
  /** What the button looks like. */
  declare face: TemplateResult | string;
  declare label: string;
  declare open: boolean;
  #off: AbortController | null = null;

  constructor() {
    super();
    this.items = [];
    this.face = '';
    this.label = '';
    this.open = false;
  }

  protected override createRenderRoot(): this {
    return this;
  }

  protected override render() {
    return html`
      <button
        type="button" class="button menu-button" aria-haspopup="menu" aria-expanded=${this.open}
        aria-label=${this.label || nothing} title=${this.label || nothing}
        @click=${() => this.#toggle(!this.open)} @keydown=${this.#buttonKey}
      >${this.face}</button>
      ${this.open ? html`<div class="menu" role="menu" aria-label=${this.label} @keydown=${this.#menuKey}>${this.items.map(this.#item)}</div>` : nothing}
    `;
  }

  readonly #item = (item: MenuItem) => html`
    <button type="button" role="menuitem" tabindex="-1" ?data-first=${item.isFirst} @click=${() => this.#choose(item)}>
      ${item.picture ? html`<img src=${item.picture} alt="" width="52" height="52" />` : nothing}
      <span><b>${item.label}</b>${item.about ? html`<small>${item.about}</small>` : nothing}</span>
    </button>
  `;

  #choose(item: MenuItem): void {
    this.#toggle(false, true);
    item.run();
  }

  #toggle(open: boolean, refocus = false): void {
    this.open = open;
    this.#off?.abort();
    if (refocus) this.querySelector<HTMLElement>('.menu-button')?.focus();
    if (!open) return;
    this.#off = new AbortController();
    const outside = (event: Event) => {
      if (!this.contains(event.target as Node)) this.#toggle(false);
    };
    document.addEventListener('pointerdown', outside, { signal: this.#off.signal, capture: true });
    document.addEventListener('focusin', outside, { signal: this.#off.signal });
    void this.updateComplete.then(() => {
      this.#place();
      this.#walk(0);
    });
  }

  /** Under the button, or above it where there is more room; free of what its surroundings cut off. */
  #place(): void {
    const menu = this.querySelector<HTMLElement>('.menu')!;
    if (matchMedia('(max-width: 760px)').matches) return;
    const button = this.getBoundingClientRect();
    const left = Math.min(button.left, innerWidth - menu.offsetWidth - 18);
    const below = button.bottom + 8 + menu.offsetHeight <= innerHeight - 12;
    const top = below ? button.bottom + 8 : Math.max(12, button.top - 8 - menu.offsetHeight);
    menu.style.left = `${Math.max(12, left)}px`;
    menu.style.top = `${top}px`;
  }

  readonly #buttonKey = (event: KeyboardEvent): void => {
    if (event.key !== 'ArrowDown') return;
    event.preventDefault();
    this.#toggle(true);
  };

  readonly #menuKey = (event: KeyboardEvent): void => {
    const buttons = this.#buttons();
    const here = buttons.indexOf(document.activeElement as HTMLElement);
    if (event.key === 'ArrowDown') this.#walk(here + 1);
    else if (event.key === 'ArrowUp') this.#walk(here - 1);
    else if (event.key === 'Home') this.#walk(0);
    else if (event.key === 'End') this.#walk(-1);
    else if (event.key === 'Escape') this.#toggle(false, true);
    else return;
    event.preventDefault();
    event.stopPropagation();
  };

  #buttons(): HTMLElement[] {
    return [...this.querySelectorAll<HTMLElement>('[role=menuitem]')];
  }

  #walk(to: number): void {
    const buttons = this.#buttons();
    buttons[(to + buttons.length) % buttons.length]?.focus();
  }
}

customElements.define('whittle-menu', WhittleMenu);
