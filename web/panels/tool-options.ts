import type { TemplateResult } from 'lit';
import type { Page } from '../app/actions.ts';
import type { Tools } from '../tools/all.ts';
import type { ToolId } from '../tools/tool.ts';
import { cubeOptions } from './cube-options.ts';
import { moveOptions } from './move-options.ts';
import { paintOptions } from './paint-options.ts';
import { selectOptions } from './select-options.ts';

/** The options of each tool that has some. */
const options: Partial<Record<ToolId, (page: Page, tools: Tools) => TemplateResult>> = {
  select: selectOptions,
  move: (page, { move }) => moveOptions(page, move),
  cube: cubeOptions,
  paint: (page, { paint }) => paintOptions(page, paint),
};

/** What can be set of a tool; null where there is nothing. */
export function toolOptions(id: ToolId, page: Page): TemplateResult | null {
  const tools = page.tools.all;
  return (tools && options[id]?.(page, tools)) ?? null;
}
