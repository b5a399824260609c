// Pictures of the samples and of what the methods do, taken from the page itself: node web/build/thumbnails.mjs <address of the page>
// Run it by hand when the samples, the methods or the look of the stage change, after `npm run build`; the pictures are kept in
// public/thumbnails.
import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { chromium } from 'playwright-core';
import { readMesh } from '../../dist/index.node.js';

const root = join(dirname(fileURLToPath(import.meta.url)), '../..');
const folder = join(root, 'public/thumbnails');
const side = 104;
const samples = ['rabbit', 'suzanne', 'vase', 'jar', 'knot'];
/** What each method is shown by: a sample, and the one step that is done to it. */
const methods = {
  cubic: ['rabbit', { lambda: 0.8 }],
  analogy: ['rabbit', { style: 'octahedron', lambda: 8, regularizer: 'farap' }],
  polycube: ['rabbit', {}],
  normalmap: ['jar', { image: 'weave', strength: 2, repeat: 2 }],
  developable: ['rabbit', { creases: 1, maxIterations: 600 }],
  reshape: ['vase', { handles: longNeck() }],
  arap: ['rabbit', { handles: longEars() }],
};

mkdirSync(join(folder, 'methods'), { recursive: true });
const browser = await chromium.launch({
  executablePath: process.env.CHROMIUM_PATH ?? '/usr/bin/chromium',
  args: ['--no-sandbox'],
});
const page = await browser.newPage({ viewport: { width: 1100, height: 700 }, reducedMotion: 'reduce' });
await page.goto(process.argv[2]);
await settled();
for (const name of [...samples.slice(1), samples[0]]) {
  await openSample(name);
  await save(`${name}.webp`);
}
for (const [method, [sample, parameters]] of Object.entries(methods)) {
  await openSample(sample);
  await take({ whittle: 1, steps: [{ method, ...parameters }] });
  await save(`methods/${method}.webp`);
}
await browser.close();

async function openSample(name) {
  await page.click('whittle-topbar .menu-button');
  await page.locator('[role=menuitem]').nth(samples.indexOf(name)).click();
  await entered(`Open ${name}`);
}

async function take(recipe) {
  const [chooser] = await Promise.all([page.waitForEvent('filechooser'), page.click('[data-act=open]')]);
  const buffer = Buffer.from(JSON.stringify(recipe));
  await chooser.setFiles([{ name: 'picture.whittle.json', mimeType: 'application/json', buffer }]);
  await entered('Recipe picture');
}

async function save(name) {
  writeFileSync(join(folder, name), Buffer.from(await picture(), 'base64'));
}

/** Holds the rabbit's feet and pulls its ears: far up, and a little back. */
function longEars() {
  const { positions } = readMesh(readFileSync(join(root, 'public/samples/rabbit.glb')), 'rabbit.glb').mesh;
  const vertices = [...positions.keys()].filter((k) => k % 3 === 0).map((k) => k / 3);
  const heights = vertices.map((v) => positions[3 * v + 1]);
  const low = heights.reduce((a, b) => Math.min(a, b));
  const size = heights.reduce((a, b) => Math.max(a, b)) - low;
  const share = (v) => (heights[v] - low) / size;
  const place = (v) => [...positions.subarray(3 * v, 3 * v + 3)];
  const held = vertices.filter((v) => share(v) < 0.45);
  const pulled = vertices.filter((v) => share(v) > 0.93);
  const targets = pulled.map(place).map(([x, y, z]) => [x, y + 0.55 * size, z - 0.1 * size]);
  return { vertices: [...held, ...pulled], targets: [...held.map(place), ...targets] };
}

/** Holds the vase's foot and raises its rim. */
function longNeck() {
  const { positions } = readMesh(readFileSync(join(root, 'public/samples/vase.obj')), 'vase.obj').mesh;
  const vertices = [...positions.keys()].filter((k) => k % 3 === 0).map((k) => k / 3);
  const heights = vertices.map((v) => positions[3 * v + 1]);
  const low = heights.reduce((a, b) => Math.min(a, b));
  const size = heights.reduce((a, b) => Math.max(a, b)) - low;
  const share = (v) => (heights[v] - low) / size;
  const place = (v) => [...positions.subarray(3 * v, 3 * v + 3)];
  const held = vertices.filter((v) => share(v) < 0.02);
  const raised = vertices.filter((v) => share(v) > 0.98);
  const targets = raised.map(place).map(([x, y, z]) => [x, y + 0.6 * size, z]);
  return { vertices: [...held, ...raised], targets: [...held.map(place), ...targets] };
}

/** Waits until an entry for undo begins so, and for its shape. */
async function entered(label) {
  await page.waitForSelector(`[data-act=undo][aria-label^="Undo ${label}"]`);
  await settled();
}

function settled() {
  return page.waitForFunction(() => {
    const status = document.querySelector('whittle-status');
    return (
      status?.dataset.activity === 'idle' && status.textContent.match(/(Carved|Shaped) in|Nothing is held/)
    );
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
  return page.evaluate(
    async ([data, side]) => {
      const image = await createImageBitmap(await (await fetch(`data:image/png;base64,${data}`)).blob());
      const { width, height } = image;
      const whole = new OffscreenCanvas(width, height).getContext('2d');
      whole.drawImage(image, 0, 0);
      const { data: pixels } = whole.getImageData(0, 0, width, height);
      // What is solid; the shadow is not.
      const [xs, ys] = [[], []];
      for (let k = 0; k < width * height; k++)
        if (pixels[4 * k + 3] > 250) {
          xs.push(k % width);
          ys.push(Math.floor(k / width));
        }
      const ends = (list) => [list.reduce((a, b) => Math.min(a, b)), list.reduce((a, b) => Math.max(a, b))];
      const [[left, right], [top, bottom]] = [ends(xs), ends(ys)];
      const size = 1.12 * Math.max(right - left, bottom - top);
      const canvas = new OffscreenCanvas(side, side);
      const pen = canvas.getContext('2d');
      pen.imageSmoothingQuality = 'high';
      const [x, y] = [(left + right - size) / 2, (top + bottom - size) / 2];
      pen.drawImage(image, x, y, size, size, 0, 0, side, side);
      const bytes = new Uint8Array(
        await (await canvas.convertToBlob({ type: 'image/webp', quality: 0.9 })).arrayBuffer(),
      );
      return btoa(String.fromCharCode(...bytes));
    },
    [shot.toString('base64'), side],
  );
}
