import { Editor } from '../src/editor/editor.ts';
import { Presenter } from '../src/editor/presenter.ts';
import { createBrowserEngine } from '../src/engine/in-browser.ts';
import { Interaction } from '../src/viewer/interaction.ts';
import { Viewer } from '../src/viewer/viewer.ts';
import { Page } from './app/actions.ts';
import { Comparing } from './app/comparing.ts';
import { CubeActions } from './app/cube-actions.ts';
import { listenForDrops } from './app/drop.ts';
import { followMethod } from './app/follow-method.ts';
import { HandleActions } from './app/handle-actions.ts';
import { ImageActions } from './app/image-actions.ts';
import { followLayout } from './app/layout.ts';
import { LineActions } from './app/line-actions.ts';
import { followLines } from './app/line-paint.ts';
import { followOverlay } from './app/overlay-paint.ts';
import { newPageStore } from './app/page-state.ts';
import { PlaneActions } from './app/plane-actions.ts';
import { readImage } from './app/read-image.ts';
import { begin } from './app/returning.ts';
import { SavingActions } from './app/saving.ts';
import { Selectable } from './app/selectable.ts';
import { Selecting } from './app/selecting.ts';
import { listenForShortcuts } from './app/shortcuts.ts';
import { StrengthActions } from './app/strength-actions.ts';
import { StyleActions } from './app/style-actions.ts';
import { followTheme } from './app/theme.ts';
import { ToolBelt } from './app/tool-belt.ts';
import './panels/all.ts';
import type { PageElement } from './panels/page-element.ts';
import './css/all.css';
import { makeTools } from './tools/all.ts';
import { NormalPainter } from './tools/paint-normals.ts';

const element = (selector: string) => document.querySelector<HTMLElement>(selector)!;

const store = newPageStore();
const viewer = openViewer();
const lessMotion = matchMedia('(prefers-reduced-motion: reduce)');
const glide = () => (lessMotion.matches ? 0 : 260);
const presenter = new Presenter(viewer, { glide, drawn: nextFrame });
const engine = createBrowserEngine();
const asset = (name: string) => store.state.gallery.entries.find(({ source }) => source === name)?.asset;
const editor = new Editor({ store, engine, presenter, surroundings: { decodeImage: readImage, asset } });
const styles = new StyleActions({ store, editor, engine, drawn: nextFrame });
const images = new ImageActions(store, editor);
const soon = (run: () => void) => requestAnimationFrame(run);
const painter = new NormalPainter(store, editor, soon);
const selecting = new Selecting(store, editor);
const interaction = viewer && new Interaction(viewer);
const surface = new Selectable(() => store.set({}));
const handles = new HandleActions(store, editor);
const cube = new CubeActions(store, editor);
const strength = new StrengthActions(store, editor);
const planes = new PlaneActions(store, editor);
const lines = new LineActions(store, editor);
const parts = { store, handles, planes, cube, strength, lines, surface, selecting, soon };
const tools = new ToolBelt(store, interaction, interaction && makeTools({ ...parts, interaction }));
const comparing = new Comparing({ store, editor, engine, interaction, drawn: nextFrame });
const saving = new SavingActions({ store, editor, engine, styles, images });
const page = new Page({
  store,
  editor,
  styles,
  images,
  painter,
  handles,
  cube,
  planes,
  selecting,
  strength,
  lines,
  tools,
  comparing,
  saving,
  presenter,
  viewer,
});

followTheme(store, viewer);
followOverlay(store, viewer);
followLines(store, interaction?.layers ?? null);
followMethod(page);
for (const panel of document.querySelectorAll<PageElement>('[data-panel]')) panel.page = page;
if (viewer)
  followLayout({ viewer, store, comparing }, element('#stage'), {
    panel: element('.sheet'),
    bar: element('whittle-viewbar'),
    strip: element('whittle-tool-strip'),
    options: element('whittle-tool-options'),
  });
listenForDrops(page);
listenForShortcuts(page, () => element('whittle-help').dispatchEvent(new Event('open')));
void begin(page);

function openViewer(): Viewer | null {
  try {
    return new Viewer(element('#canvas') as HTMLCanvasElement, {
      onContext: (lost) =>
        store.set({
          notice: lost
            ? {
                tone: 'note',
                text: 'The graphics card was taken away for a moment; the picture comes back by itself.',
              }
            : null,
        }),
    });
  } catch (thrown) {
    const sentence = document.createElement('p');
    sentence.className = 'no-canvas';
    sentence.role = 'alert';
    sentence.textContent = (thrown as Error).message;
    element('#stage').append(sentence);
    return null;
  }
}

/** Resolves once what was drawn last is on the screen; at once where nothing is animated (a hidden tab). */
function nextFrame(): Promise<void> {
  if (document.hidden) return Promise.resolve();
  return new Promise((resolve) => requestAnimationFrame(() => resolve()));
}
