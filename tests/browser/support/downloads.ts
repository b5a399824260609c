import { readdirSync, readFileSync, rmSync, statSync } from 'node:fs';
import { join } from 'node:path';
import { buffer } from 'node:stream/consumers';
import type { Page } from 'playwright-core';
import { inject } from 'vitest';
import { until } from '../../fixtures/until.ts';
import { browserName } from './connect.ts';

export interface SavedFile {
  readonly name: string;
  readonly bytes: Buffer;
}

/** Does something on a page and waits for the one file that the browser saves then. */
export async function saved(page: Page, act: () => Promise<unknown>): Promise<SavedFile> {
  if (browserName === 'firefox') return savedToFolder(act);
  const [download] = await Promise.all([page.waitForEvent('download'), act()]);
  return { name: download.suggestedFilename(), bytes: await buffer(await download.createReadStream()) };
}

/** Firefox tells over BiDi that it saves something, but not under which id, and Playwright then says nothing: the folder does. */
async function savedToFolder(act: () => Promise<unknown>): Promise<SavedFile> {
  const folder = inject('shared').downloads;
  await act();
  let finished: string | undefined;
  let before = '';
  let looks = 0;
  await until(() => {
    // What is under way is an empty file with its name and another that ends in `.part` or has a name for the time being.
    const names = readdirSync(folder);
    const sizes = names.map((name) => statSync(join(folder, name), { throwIfNoEntry: false })?.size ?? 0);
    const now = `${names} ${sizes}`;
    looks = now === before && names.length === 1 && sizes[0]! > 0 ? looks + 1 : 0;
    before = now;
    if (looks >= 20) finished = names[0];
    return finished !== undefined;
  });
  const path = join(folder, finished!);
  const bytes = readFileSync(path);
  rmSync(path);
  return { name: finished!, bytes };
}
