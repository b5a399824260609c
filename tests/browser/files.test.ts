import { strToU8, zipSync } from 'fflate';
import { expect, it } from 'vitest';
import { dracoCube, meshoptCube } from '../fixtures/compressed.ts';
import { gltfBuffer, gltfJson, packGlb, text } from '../fixtures/tiny-files.ts';
import { carved, drop } from './support/browser.ts';
import { saved } from './support/downloads.ts';
import { usePage } from './support/use-page.ts';

const pages = usePage();

it('takes a zip of a glTF with its data beside it, and gives it back in one file', async () => {
  const page = await pages.open();
  const json = { ...gltfJson(), buffers: [{ byteLength: 1032, uri: 'data/cube.bin' }] };
  const zip = zipSync({
    'cube/cube.gltf': strToU8(JSON.stringify(json)),
    'cube/data/cube.bin': gltfBuffer(),
  });
  await drop(page, '#canvas', 'cube.zip', zip);
  await page.waitForSelector('.notice');
  expect(await page.locator('.notice').innerText()).toMatch(/data\/cube\.bin.*inside/);
  await carved(page);
  expect(await page.locator('.report summary').innerText()).toContain('12 faces');
  const written = await saved(page, () => page.keyboard.press('e'));
  expect(text(written.bytes)).toContain('"uri":"data:application/octet-stream;base64,');
});

it.each([
  ['Draco', dracoCube],
  ['meshopt', () => meshoptCube(packGlb)],
] as const)('loads a decoder for %s without asking anyone else', async (what, make) => {
  const page = await pages.open();
  const asked: string[] = [];
  page.on('request', (request) => asked.push(request.url()));
  await drop(page, '#canvas', 'cube.glb', await make());
  await page.waitForSelector('.notice');
  expect(await page.locator('.notice').innerText()).toContain(`It is compressed with ${what}`);
  await carved(page);
  expect(await page.locator('.report summary').innerText()).toContain('12 faces');
  const { origin } = new URL(page.url());
  expect(asked.filter((url) => /^http/.test(url) && !url.startsWith(origin))).toEqual([]);
});
