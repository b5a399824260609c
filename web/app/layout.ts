import type { Box } from '../../src/viewer/box.ts';
import type { Insets, Viewer } from '../../src/viewer/viewer.ts';
import type { Comparing } from './comparing.ts';
import { framesIn } from './frames.ts';
import type { PageStore } from './page-state.ts';

export interface LayoutParts {
  readonly viewer: Viewer;
  readonly store: PageStore;
  readonly comparing: Comparing;
}

/** Keeps the canvas as large as its box, and the object, or several pictures of it, in the part that no panel covers. */
export function followLayout(
  { viewer, store, comparing }: LayoutParts,
  stage: HTMLElement,
  { panel, bar, strip, options }: Record<'panel' | 'bar' | 'strip' | 'options', HTMLElement>,
): void {
  let narrow: boolean | null = null;
  let covered = 0;
  let pictures = 1;
  const measure = () => {
    const box = stage.getBoundingClientRect();
    const cover = panel.getBoundingClientRect();
    const isNarrow = matchMedia('(max-width: 760px)').matches;
    // On a phone the tool's options stand on the sheet, of which only the way home is left then.
    const sheet = cover.height + (isNarrow ? options.getBoundingClientRect().height : 0);
    stage.style.setProperty('--home-height', `${cover.height}px`);
    stage.style.setProperty('--sheet-height', `${sheet}px`);
    const rightOf = (one: HTMLElement) => one.getBoundingClientRect().right - box.left;
    const insets = isNarrow
      ? {
          top: 84,
          right: 0,
          bottom: Math.max(0, box.bottom - bar.getBoundingClientRect().top),
          left: rightOf(strip),
        }
      : {
          top: 64,
          right: Math.max(0, box.right - cover.left),
          bottom: 48,
          left: Math.max(rightOf(strip), rightOf(options)),
        };
    comparing.isNarrow = isNarrow;
    const count = 1 + Math.min(store.state.compared.length, comparing.most - 1);
    const frames =
      count > 1 ? framesIn(insideOf(box, insets, margin), count, isNarrow) : [insideOf(box, insets, 0)];
    viewer.setInsets(around(box, frames[0]!, count > 1 ? nameHeight : 0));
    viewer.resize(box.width, box.height, devicePixelRatio);
    comparing.layOut(frames);
    store.set({ frames });
    // Where the sheet takes much more or less of a phone than before, the object moves to where it can be seen.
    const isOther = isNarrow && Math.abs(covered - insets.bottom) > 60;
    if (narrow !== isNarrow || count !== pictures) viewer.fit(narrow === isNarrow);
    else if (isOther) viewer.fit();
    else if (!isNarrow) viewer.uncover();
    if (narrow !== isNarrow || isOther) covered = insets.bottom;
    narrow = isNarrow;
    pictures = count;
  };
  const observer = new ResizeObserver(measure);
  observer.observe(stage);
  observer.observe(panel);
  observer.observe(strip);
  observer.observe(options);
  let compared = store.state.compared;
  store.subscribe((state) => {
    if (state.compared.length === compared.length) return;
    compared = state.compared;
    measure();
  });
  measure();
}

/** Around pictures side by side, and what their names take of their height, in CSS pixels. */
const margin = 10;
const nameHeight = 44;

function insideOf(box: DOMRect, { top, right, bottom, left }: Insets, margin: number): Box {
  const width = box.width - left - right - 2 * margin;
  const height = box.height - top - bottom - 2 * margin;
  return { left: left + margin, top: top + margin, width, height };
}

/** What is left of the canvas around a frame and its name. */
function around(box: DOMRect, { left, top, width, height }: Box, name: number): Insets {
  const air = name > 0 ? 0.04 * Math.min(width, height) : 0;
  const [right, bottom] = [box.width - left - width, box.height - top - height];
  return { left: left + air, top: top + name, right: right + air, bottom: bottom + air };
}
