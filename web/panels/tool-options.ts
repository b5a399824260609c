import type { TemplateResult } from 'lit';
import type { Page } from '../app/actions.ts';
import type { ToolId } from '../tools/tool.ts';

/** The options of each tool that has some. */
const options: Partial<Record<ToolId, (page: Page) => TemplateResult>> = {};

/** What can be set of a tool; null where there is nothing. */
export function toolOptions(tool: ToolId, page: Page): TemplateResult | null {
  return options[tool]?.(page) ?? null;
}
