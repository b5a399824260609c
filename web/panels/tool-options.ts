import { html, type TemplateResult } from 'lit';
import type { Page } from '../app/actions.ts';
import type { Tools } from '../tools/all.ts';
import type { ToolId } from '../tools/tool.ts';
import { cubeOptions } from './cube-options.ts';
import { lineOptions } from './line-options.ts';
import { moveOptions } from './move-options.ts';
import { PageElement } from './page-element.ts';
import { paintOptions } from './paint-options.ts';
import { selectOptions } from './select-options.ts';

/** The options of each tool that has some. */
const options: Partial<Record<ToolId, (page: Page, tools: Tools) => TemplateResult>> = {
  select: selectOptions,
  move: (page, { move }) => moveOptions(page, move),
  lines: (page, { lines }) => lineOptions(page, lines),
  cube: cubeOptions,
  paint: (page, { paint }) => paintOptions(page, paint),
};

/** What can be set of the tool that is in the hand; hidden where there is nothing. On a phone it stands in for the settings. */
export class WhittleToolOptions extends PageElement {
  override connectedCallback(): void {
    super.connectedCallback();
    this.role = 'region';
    this.ariaLabel = 'What the tool does';
  }

  protected override render() {
    const { tool, project } = this.state;
    const tools = this.page.tools.all;
    const template = (project && tools && options[tool]?.(this.page, tools)) ?? null;
    this.hidden = template === null;
    return html`${template}`;
  }
}

customElements.define('whittle-tool-options', WhittleToolOptions);
