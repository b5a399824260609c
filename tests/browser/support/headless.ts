import { mkdtemp, readFile, rm, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import type { Page } from 'playwright-core';
import { runCommandLine } from '../../../src/cli/command-line.ts';
import { type SavedFile, saved } from './downloads.ts';

/** What the page saves under an item of its export menu. */
export function exported(page: Page, label: string): Promise<SavedFile> {
  return saved(page, async () => {
    await page.getByRole('button', { name: 'Other ways to export' }).click();
    await page.getByRole('menuitem', { name: new RegExp(`^${label}`) }).click();
  });
}

/**
 * What the command line makes of a mesh by the recipe of a page.
 *
 * @param mesh path of the file that the page has opened
 * @param named files that the recipe names
 */
export async function shapedHeadless(
  recipe: SavedFile,
  mesh: string,
  named: readonly SavedFile[] = [],
): Promise<Buffer> {
  const folder = await mkdtemp(join(tmpdir(), 'whittle-headless-'));
  try {
    const saidBy = join(folder, recipe.name);
    await writeFile(saidBy, recipe.bytes);
    for (const { name, bytes } of named) await writeFile(join(folder, name), bytes);
    const out = join(folder, `headless${mesh.slice(mesh.lastIndexOf('.'))}`);
    const said: string[] = [];
    const stream = { write: (text: string) => said.push(text) > 0 };
    const code = await runCommandLine(['run', saidBy, mesh, '--out', out], {
      stdout: stream,
      stderr: stream,
      signal: new AbortController().signal,
    });
    if (code !== 0) throw new Error(said.join(''));
    return await readFile(out);
  } finally {
    await rm(folder, { recursive: true });
  }
}
