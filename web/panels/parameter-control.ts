import { html, LitElement, nothing } from 'lit';
import { live } from 'lit/directives/live.js';
import type { ChoiceParameter } from '../../src/methods/values/choice.ts';
import type { FlagParameter } from '../../src/methods/values/flag.ts';
import type { NumberParameter } from '../../src/methods/values/number.ts';
import type { EditableParameter } from '../app/offered-methods.ts';
import { fromTravel, spoken, toTravel, travel } from './slider-scale.ts';

/** Where a gesture is. `preview` comes any number of times, then one `commit`. */
export interface ParameterChange {
  readonly name: string;
  readonly value: number | string | boolean;
  readonly phase: 'preview' | 'commit';
}

/** The control that a parameter's descriptor asks for. Fires `parameter` with a {@link ParameterChange}. */
export class WhittleParameter extends LitElement {
  static override properties = {
    parameter: { attribute: false },
    value: { attribute: false },
    explained: { type: Boolean },
  };
  declare parameter: EditableParameter;
  declare value: number | string | boolean;
  /** What it does is written under it; else the pointer has to rest on it. */
  declare explained: boolean;
  /** A key is down: what it repeats is one gesture until it is let go. */
  #keyDown = false;
  #pending: number | null = null;

  protected override createRenderRoot(): this {
    return this;
  }

  protected override render() {
    const { parameter } = this;
    if (!parameter) return nothing;
    return html`${this.#control(parameter)}${this.explained ? html`<p class="explained">${sentence(parameter)}</p>` : nothing}`;
  }

  #control(parameter: EditableParameter) {
    if (parameter.kind === 'flag') return this.#flag(parameter);
    if (parameter.kind === 'choice') return this.#choice(parameter);
    return parameter.slider ? this.#slider(parameter) : this.#field(parameter);
  }

  protected override updated(): void {
    const { parameter } = this;
    if (parameter?.kind !== 'number' && parameter?.kind !== 'integer') return;
    const range = this.querySelector<HTMLInputElement>('input[type=range]');
    if (!range || !parameter.slider) return;
    range.style.setProperty('--share', String(toTravel(parameter, Number(this.value)) / travel));
  }

  #slider(parameter: NumberParameter) {
    const id = `parameter-${parameter.name}`;
    return html`
      <div class="slider">
        <label for=${id} title=${sentence(parameter)}>${parameter.label}</label>
        ${this.#number(parameter, `${parameter.label}, exact value`)}
        <input
          id=${id} type="range" min="0" max=${travel} step="1" aria-describedby="${id}-doc"
          aria-valuetext=${spoken(Number(this.value))} .value=${String(toTravel(parameter, Number(this.value)))}
          @input=${this.#slid} @change=${this.#let} @keydown=${this.#press} @keyup=${this.#release} @blur=${this.#lift}
        />
        <span class="hidden" id="${id}-doc">${sentence(parameter)}</span>
      </div>
    `;
  }

  #field(parameter: NumberParameter) {
    return html`<label class="field" title=${sentence(parameter)}><span>${parameter.label}</span>${this.#number(parameter)}</label>`;
  }

  #number(parameter: NumberParameter, label?: string) {
    return html`<input
      class="number" type="number" inputmode="decimal" min=${parameter.min} max=${parameter.max} step="any"
      aria-label=${label ?? nothing} .value=${spoken(Number(this.value))} @change=${this.#typed}
    />`;
  }

  #choice(parameter: ChoiceParameter) {
    const name = (choice: string) => parameter.labels?.[choice] ?? choice;
    const letters = parameter.choices.reduce((sum, choice) => sum + name(choice).length, 0);
    return letters <= fewLetters ? this.#switch(parameter, name) : this.#select(parameter, name);
  }

  /** All choices side by side. */
  #switch({ name, label, choices, ...parameter }: ChoiceParameter, nameOf: (choice: string) => string) {
    return html`
      <fieldset class="field either" title=${sentence(parameter)}>
        <legend>${label}</legend>
        <span class="either-faces">
          ${choices.map(
            (choice) => html`
              <label><input type="radio" name=${name} .value=${choice} .checked=${live(choice === this.value)} @change=${this.#chosen} /><span>${nameOf(choice)}</span></label>`,
          )}
        </span>
      </fieldset>
    `;
  }

  #select(parameter: ChoiceParameter, nameOf: (choice: string) => string) {
    return html`
      <label class="field" title=${sentence(parameter)}><span>${parameter.label}</span>
        <select .value=${String(this.value)} @change=${this.#chosen}>
          ${parameter.choices.map((choice) => html`<option value=${choice} ?selected=${choice === this.value}>${nameOf(choice)}</option>`)}
        </select>
      </label>
    `;
  }

  #flag(parameter: FlagParameter) {
    return html`
      <label class="field" title=${sentence(parameter)}><span>${parameter.label}</span>
        <input type="checkbox" .checked=${this.value === true} @change=${(event: Event) => this.#fire((event.target as HTMLInputElement).checked, 'commit')} />
      </label>
    `;
  }

  readonly #chosen = (event: Event): void =>
    this.#fire((event.target as HTMLInputElement | HTMLSelectElement).value, 'commit');

  readonly #slid = (event: Event): void => this.#fire(this.#read(event), 'preview');

  readonly #let = (event: Event): void => {
    const value = this.#read(event);
    if (this.#keyDown) this.#pending = value;
    else this.#fire(value, 'commit');
  };

  readonly #press = (event: KeyboardEvent): void => {
    if (slides(event)) this.#keyDown = true;
  };

  readonly #release = (event: KeyboardEvent): void => {
    if (slides(event)) this.#lift();
  };

  readonly #lift = (): void => {
    this.#keyDown = false;
    if (this.#pending !== null) this.#fire(this.#pending, 'commit');
    this.#pending = null;
  };

  readonly #typed = (event: Event): void => {
    const input = event.target as HTMLInputElement;
    const { min, max, kind } = this.parameter as NumberParameter;
    const typed = input.valueAsNumber;
    if (Number.isNaN(typed)) {
      input.value = spoken(Number(this.value));
      return;
    }
    const value = Math.min(max, Math.max(min, kind === 'integer' ? Math.round(typed) : typed));
    input.value = spoken(value);
    this.#fire(value, 'commit');
  };

  #read(event: Event): number {
    return fromTravel(this.parameter as NumberParameter, (event.target as HTMLInputElement).valueAsNumber);
  }

  #fire(value: number | string | boolean, phase: ParameterChange['phase']): void {
    const detail: ParameterChange = { name: this.parameter.name, value, phase };
    this.dispatchEvent(new CustomEvent('parameter', { detail, bubbles: true }));
  }
}

/** As many letters stand side by side in the panel. */
const fewLetters = 18;

function sentence({ hint, doc }: Pick<EditableParameter, 'hint' | 'doc'>): string {
  return hint ?? doc;
}

function slides({ key }: KeyboardEvent): boolean {
  return /^(Arrow|Page|Home|End)/.test(key);
}

customElements.define('whittle-parameter', WhittleParameter);
