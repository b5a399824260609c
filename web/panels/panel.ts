import { html, nothing } from 'lit';
import { activeStep, type Project, type Step } from '../../src/editor/project.ts';
import { imageParameter, styleParameter } from '../../src/editor/starting-step.ts';
import { formats } from '../../src/io/index.ts';
import { oddities } from '../../src/mesh/report-sentences.ts';
import type { MethodDescriptor } from '../../src/methods/descriptor.ts';
import { findMethod } from '../../src/methods/registry.ts';
import { isUnheld } from '../../src/methods/set-by-hand.ts';
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
import { methodPicture } from './method-picker.ts';
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
    const method = step && findMethod(step.method);
    return html`
      <div class="settings">
        ${project ? html`<whittle-stack .page=${this.page}></whittle-stack>` : nothing}
        <whittle-method-picker .page=${this.page}></whittle-method-picker>
        ${method ? this.#settings(method, step) : nothing}
        ${project ? this.#rest(project) : nothing}
      </div>
      ${project ? this.#home(project) : nothing}
    `;
  }

  /** What the method borrows, its few controls, and the solver's behind a fold. */
  #settings(method: MethodDescriptor, step: Step) {
    const style = styleParameter(method);
    const editable = editableParameters(method, this.page.images.chosen.image !== undefined);
    const control = (parameter: EditableParameter, explained: boolean) =>
      html`<whittle-parameter .parameter=${parameter} .value=${step.parameters[parameter.name]} .explained=${explained}></whittle-parameter>`;
    const solver = editable.filter(({ advanced }) => advanced);
    const plain = editable.filter(({ advanced }) => !advanced);
    // What is dragged comes first: it should not be scrolled for.
    const sliders = plain.filter((parameter) => 'slider' in parameter);
    const others = plain.filter((parameter) => !sliders.includes(parameter));
    return html`
      <div class="controls" @parameter=${this.#change}>${sliders.map((parameter) => control(parameter, false))}</div>
      ${style ? this.#styles(style) : nothing}
      ${imageParameter(method) ? html`<whittle-images data-takes-images .page=${this.page}></whittle-images>` : nothing}
      ${this.#byHand(method)}
      <div class="controls" @parameter=${this.#change}>${others.map((parameter) => control(parameter, false))}</div>
      ${this.#remarks(method, step)}
      <details class="solver" @parameter=${this.#change}>
        <summary>Solver</summary>
        ${solver.map((parameter) => control(parameter, true))}
        <button type="button" class="button small" data-act="reset" title="All as it was at first (R)" @click=${() => void this.page.editor.reset()}>${icon('reset')}Reset ${method.title}</button>
      </details>
    `;
  }

  /** What the last run had to say of its result: a compromise, or what it was worked out on. What mesh and image have to do with is said there. */
  #remarks(method: MethodDescriptor, { result, parameters }: Step) {
    const elsewhere = [
      ...(this.state.project ? oddities(this.state.project.report) : []),
      this.page.images.remark,
    ];
    const own = result?.warnings.filter((warning) => !elsewhere.includes(warning)) ?? [];
    if (own.length === 0 || isUnheld(method, parameters)) return nothing;
    return html`<ul class="remarks" aria-label="About this result">${own.map((remark) => html`<li>${remark}</li>`)}</ul>`;
  }

  /** What is moved by hand needs the tool for it. */
  #byHand(method: MethodDescriptor) {
    const face = this.page.tools.faces.find(({ id }) => id === 'move');
    if (!face || method.intent !== 'move' || this.state.tool === face.id) return nothing;
    return html`<button type="button" class="button small" data-act="take-move" title=${face.does} @click=${() => this.page.tools.choose(face.id)}>${icon(face.id)}Hold and pull parts</button>`;
  }

  /** What is there for every method. */
  #rest(project: Project) {
    return html`
      ${this.#addition(project)}
      ${measures(this.page, this.state)}
      ${meshReport(project)}
    `;
  }

  #styles({ mapping }: StyleParameter) {
    const painting = this.state.gallery.painting && mapping !== 'closest';
    return html`
      <div class="styles" data-takes-styles>
        <whittle-gallery .page=${this.page}></whittle-gallery>
        ${painting ? html`<whittle-painter .page=${this.page}></whittle-painter>` : nothing}
      </div>`;
  }

  /** The way to another step, for what the mesh is made for. */
  #addition({ mesh }: Project) {
    const items = offeredMethods()
      .filter((method) => obstacle(method, mesh) === undefined)
      .map((method) => ({
        label: method.title,
        picture: methodPicture(method),
        run: () => void this.page.styles.addStep(method.id),
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
      {
        label: 'Project',
        about: 'mesh and steps in one',
        isFirst: true,
        run: () => void saving.saveProject(),
      },
      { label: 'Recipe', about: 'the steps, for other meshes', run: () => saving.saveRecipe() },
      { label: 'Copy a link', about: 'to this shape', run: () => void saving.copyLink() },
      { label: 'Copy as a command', about: 'for a shell', run: () => void saving.copyCommand() },
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
