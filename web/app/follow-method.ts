import { activeStep } from '../../src/editor/project.ts';
import { findMethod } from '../../src/methods/registry.ts';
import type { Page } from './actions.ts';

/** Shades the mesh as suits the method that is on, unless the person chose another way to look. */
export function followMethod(page: Page): void {
  let method: string | undefined;
  const usual = () => findMethod(method ?? '')?.shading ?? 'smooth';
  page.store.subscribe(({ project, look }) => {
    const now = project && activeStep(project).method;
    if (!now || now === method) return;
    const isUntouched = look.shading === usual();
    method = now;
    if (isUntouched) page.look({ shading: usual() });
  });
}
