import { html, nothing } from 'lit';
import type { MethodDescriptor, ParameterDescriptor } from '../../src/methods/descriptor.ts';
import { findMethod } from '../../src/methods/registry.ts';
import type { WhittleDocument } from '../document/document.ts';
import { exportName, formats, ownFormat } from '../document/formats.ts';
import { editableParameters, offeredMethods } from '../document/offered-methods.ts';
import { icon } from './icons.ts';
import { PageElement } from './page-element.ts';
import type { ParameterChange } from './parameter-control.ts';
import { meshReport } from './report.ts';
import './menu.ts';
import './parameter-control.ts';

/** The style and its few controls, made from the method's descriptor; the way home for the result; what the mesh is like. */
export class WhittlePanel extends PageElement {
  protected override render() {
    const { document } = this.state;
    const method = document ? findMethod(document.method) : offeredMethods()[0];
    if (!method) return nothing;
    return html`
      ${this.#heading(method)}
      <div class="controls" @parameter=${this.#change}>${document ? this.#controls(method, document) : nothing}</div>
      ${document ? this.#home(document) : nothing}
      ${document ? meshReport(document) : nothing}
    `;
  }

  #heading(method: MethodDescriptor) {
    const offered = offeredMethods();
    return html`
      <header class="method">
        ${
          offered.length > 1
            ? html`<select aria-label="Style" .value=${method.id} @change=${this.#choose}>${offered.map(({ id, title }) => html`<option value=${id}>${title}</option>`)}</select>`
            : html`<h2>${method.title}</h2>`
        }
        <p title=${method.paper}>${method.summary}</p>
      </header>
    `;
  }

  #controls(method: MethodDescriptor, document: WhittleDocument) {
    const editable = editableParameters(method);
    const plain = editable.filter(({ advanced }) => !advanced);
    const advanced = editable.filter((parameter) => parameter.advanced);
    const control = (parameter: ParameterDescriptor) =>
      html`<whittle-parameter .parameter=${parameter} .value=${document.parameters[parameter.name]}></whittle-parameter>`;
    return html`
      ${plain.map(control)}
      ${
        advanced.length > 0
          ? html`<details class="more"><summary>More</summary>${advanced.map(control)}
              <button type="button" class="button small" data-act="reset" title="Reset the style (R)" @click=${() => this.page.workspace.reset()}>${icon('reset')}Reset the style</button>
            </details>`
          : nothing
      }
    `;
  }

  #home(document: WhittleDocument) {
    const own = ownFormat(document);
    const others = formats.map((format) => ({
      label: format.label,
      about: `.${format.extension}`,
      run: () => void this.page.export(format),
    }));
    const command = {
      label: 'Copy as a command',
      about: 'npx whittle …',
      run: () => void this.page.copyCommand(),
    };
    return html`
      <div class="home">
        <button type="button" class="button primary" data-act="export" title="Export ${exportName(document, own)} (E)" @click=${() => void this.page.export()}>
          ${icon('export')}<span>Export<span class="wide"> ${own.extension.toUpperCase()}</span></span>
        </button>
        <whittle-menu label="Other ways to export" .face=${icon('down')} .items=${[...others, command]}></whittle-menu>
      </div>
    `;
  }

  readonly #choose = (event: Event): void =>
    this.page.workspace.chooseMethod((event.target as HTMLSelectElement).value);

  readonly #change = (event: CustomEvent<ParameterChange>): void => {
    const { document } = this.state;
    if (!document) return;
    const { name, value, phase } = event.detail;
    const parameters = { ...document.parameters, [name]: value };
    if (phase === 'preview') this.page.workspace.preview(parameters);
    else this.page.workspace.commit(parameters, labelOf(document.method, name));
  };
}

function labelOf(method: string, parameter: string): string {
  return findMethod(method)?.parameters.find(({ name }) => name === parameter)?.label ?? parameter;
}

customElements.define('whittle-panel', WhittlePanel);
