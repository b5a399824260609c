// Pictures of the samples for the page's menu, taken from the page itself: node web/build/thumbnails.mjs <address of the page>
// Run it by hand when the samples or the look of the stage change; the pictures are kept in public/thumbnails.
import { mkdirSync, writeFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { chromium } from 'playwright-core';

const folder = join(dirname(fileURLToPath(import.meta.url)), '../../public/thumbnails');
const side = 104;
const names = ['rabbit', 'suzanne', 'vase', 'jar', 'knot'];

mkdirSync(folder, { recursive: true });
const browser = await chromium.launch({
  executablePath: process.env.CHROMIUM_PATH ?? '/usr/bin/chromium',
  args: ['--no-sandbox'],
});
const page = await browser.newPage({ viewport: { width: 700, height: 620 }, reducedMotion: 'reduce' });
await page.goto(process.argv[2]);
for (const [index, name] of names.entries()) {
  await settled();
  await page.click('whittle-topbar .menu-button');
  await page.locator('[role=menuitem]').nth(index).click();
  await page.waitForTimeout(300);
  await settled();
  writeFileSync(join(folder, `${name}.webp`), Buffer.from(await picture(), 'base64'));
}
await browser.close();

function settled() {
  return page.waitForFunction(() => {
    const status = document.querySelector('whittle-status');
    return status?.dataset.activity === 'idle' && status.textContent.includes('Carved');
  });
}

/** The square about the object with nothing behind it, as base64 of a WebP. */
async function picture() {
  const style = await page.addStyleTag({
    content:
      '#stage { background: none } body { background: none } #stage > :not(canvas) { visibility: hidden !important }',
  });
  const shot = await page.screenshot({ omitBackground: true });
  await style.evaluate((element) => element.remove());
  const cover = await page.locator('.sheet').boundingBox();
  const free = { top: 56, bottom: cover.y - 56 };
  return page.evaluate(
    async ([data, free, side]) => {
      const image = await createImageBitmap(await (await fetch(`data:image/png;base64,${data}`)).blob());
      const size = free.bottom - free.top;
      const canvas = new OffscreenCanvas(side, side);
      const pen = canvas.getContext('2d');
      pen.imageSmoothingQuality = 'high';
      pen.drawImage(image, (image.width - size) / 2, free.top, size, size, 0, 0, side, side);
      const bytes = new Uint8Array(
        await (await canvas.convertToBlob({ type: 'image/webp', quality: 0.9 })).arrayBuffer(),
      );
      return btoa(String.fromCharCode(...bytes));
    },
    [shot.toString('base64'), free, side],
  );
}
