import { html, nothing } from 'lit';
import { live } from 'lit/directives/live.js';
import { activeStep, type Project, type Step } from '../../src/editor/project.ts';
import { imageParameter, styleParameter } from '../../src/editor/starting-step.ts';
import { formats } from '../../src/io/index.ts';
import type { MethodDescriptor } from '../../src/methods/descriptor.ts';
import { findMethod } from '../../src/methods/registry.ts';
import type { StyleParameter } from '../../src/methods/values/style.ts';
import { exportName, ownFormat } from '../app/export.ts';
import {
  type EditableParameter,
  editableParameters,
  obstacle,
  offeredMethods,
} from '../app/offered-methods.ts';
import { icon } from './icons.ts';
import { measures } from './measures.ts';
import { PageElement } from './page-element.ts';
import type { ParameterChange } from './parameter-control.ts';
import { meshReport } from './report.ts';
import './gallery.ts';
import './images.ts';
import './menu.ts';
import './painter.ts';
import './parameter-control.ts';
import './stack.ts';

/** The style and its few controls, made from the method's descriptor; the way home for the result; what the mesh is like. */
export class WhittlePanel extends PageElement {
  protected override render() {
    const { project } = this.state;
    const step = project && activeStep(project);
    const method = step ? findMethod(step.method) : offeredMethods()[0];
    if (!method) return nothing;
    const style = styleParameter(method);
    return html`
      ${project ? html`<whittle-stack .page=${this.page}></whittle-stack>` : nothing}
      ${this.#heading(method)}
      ${style && project ? this.#styles(style) : nothing}
      ${imageParameter(method) && project ? html`<whittle-images data-takes-images .page=${this.page}></whittle-images>` : nothing}
      <div class="controls" @parameter=${this.#change}>${step ? this.#controls(method, step) : nothing}</div>
      ${project ? this.#addition(project) : nothing}
      ${project ? this.#home(project) : nothing}
      ${project ? measures(this.page, this.state) : nothing}
      ${project ? meshReport(project) : nothing}
    `;
  }

  #heading(method: MethodDescriptor) {
    const offered = offeredMethods();
    return html`
      <header class="method">
        ${offered.length > 1 ? this.#switch(method, offered) : html`<h2>${method.title}</h2>`}
        ${styleParameter(method) ? nothing : html`<p title=${method.paper}>${method.summary}</p>`}
      </header>
    `;
  }

  #switch(method: MethodDescriptor, offered: readonly MethodDescriptor[]) {
    return html`
      <fieldset class="switch">
        <legend class="hidden">What to do</legend>
        ${offered.map((one) => this.#face(one, one === method))}
      </fieldset>`;
  }

  /** A method that this mesh is not made for can be asked why. */
  #face(method: MethodDescriptor, isChosen: boolean) {
    const { project } = this.state;
    const why = project ? obstacle(method, project.mesh) : undefined;
    return html`
      <label title=${why ?? nothing}>
        <input type="radio" name="method" .value=${method.id} .checked=${live(isChosen)} ?data-obstacle=${why !== undefined} @change=${this.#choose} /><span class="switch-face">${method.title}</span>
      </label>`;
  }

  #styles({ mapping }: StyleParameter) {
    const painting = this.state.gallery.painting && mapping !== 'closest';
    return html`
      <div class="styles" data-takes-styles>
        <whittle-gallery .page=${this.page}></whittle-gallery>
        ${painting ? html`<whittle-painter .page=${this.page}></whittle-painter>` : nothing}
      </div>`;
  }

  #controls(method: MethodDescriptor, step: Step) {
    const editable = editableParameters(method, this.page.images.chosen.image !== undefined);
    const plain = editable.filter(({ advanced }) => !advanced);
    const advanced = editable.filter((parameter) => parameter.advanced);
    const control = (parameter: EditableParameter) =>
      html`<whittle-parameter .parameter=${parameter} .value=${step.parameters[parameter.name]}></whittle-parameter>`;
    return html`
      ${plain.map(control)}
      ${
        advanced.length > 0
          ? html`<details class="more"><summary>More</summary>${advanced.map(control)}
              <button type="button" class="button small" data-act="reset" title="Reset the style (R)" @click=${() => void this.page.editor.reset()}>${icon('reset')}Reset the style</button>
            </details>`
          : nothing
      }
    `;
  }

  /** The way to another step, for what the mesh is made for. */
  #addition({ mesh }: Project) {
    const items = offeredMethods()
      .filter((method) => obstacle(method, mesh) === undefined)
      .map(({ id, title, summary }) => ({
        label: title,
        about: summary,
        run: () => void this.page.styles.addStep(id),
      }));
    return html`<whittle-menu class="add-step" label="Add a step" .face=${html`${icon('add')}<span>Add a step</span>`} .items=${items}></whittle-menu>`;
  }

  #home(project: Project) {
    const own = ownFormat(project);
    const others = formats.map((format) => ({
      label: format.label,
      about: format.ending,
      run: () => void this.page.export(format),
    }));
    const { saving } = this.page;
    const work = [
      { label: 'Project', about: 'mesh and steps in one file', run: () => void saving.saveProject() },
      { label: 'Recipe', about: 'the steps, for other meshes', run: () => saving.saveRecipe() },
      { label: 'Copy a link', about: 'to this shape', run: () => void saving.copyLink() },
      { label: 'Copy as a command', about: 'npx whittle …', run: () => void saving.copyCommand() },
    ];
    return html`
      <div class="home">
        <button type="button" class="button primary" data-act="export" title="Export ${exportName(project, own.ending)} (E)" @click=${() => void this.page.export()}>
          ${icon('export')}<span>Export<span class="wide"> ${own.ending.slice(1).toUpperCase()}</span></span>
        </button>
        <whittle-menu label="Other ways to export" .face=${icon('down')} .items=${[...others, ...work]}></whittle-menu>
      </div>
    `;
  }

  readonly #choose = (event: Event): void => {
    this.page.chooseMethod((event.target as HTMLInputElement).value);
    this.requestUpdate(); // it may have stayed with what it was
  };

  readonly #change = (event: CustomEvent<ParameterChange>): void => {
    const { project } = this.state;
    const step = project && activeStep(project);
    if (!step) return;
    const { name, value, phase } = event.detail;
    const parameters = this.page.strength.rescaled({ ...step.parameters, [name]: value });
    if (phase === 'preview') this.page.editor.preview({ parameters });
    else this.page.editor.commit({ parameters }, labelOf(step.method, name));
  };
}

function labelOf(method: string, parameter: string): string {
  return findMethod(method)?.parameters.find(({ name }) => name === parameter)?.label ?? parameter;
}

customElements.define('whittle-panel', WhittlePanel);
