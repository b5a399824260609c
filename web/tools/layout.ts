import type { Viewer } from '../../src/viewer/viewer.ts';

/** Keeps the canvas as large as its box and the object centred in the part that no panel covers. */
export function followLayout(viewer: Viewer, stage: HTMLElement, panel: HTMLElement, bar: HTMLElement): void {
  let narrow: boolean | null = null;
  const measure = () => {
    const box = stage.getBoundingClientRect();
    const cover = panel.getBoundingClientRect();
    stage.style.setProperty('--sheet-height', `${cover.height}px`);
    const isNarrow = matchMedia('(max-width: 760px)').matches;
    const insets = isNarrow
      ? { top: 56, right: 0, bottom: Math.max(0, box.bottom - bar.getBoundingClientRect().top), left: 0 }
      : { top: 40, right: Math.max(0, box.right - cover.left), bottom: 40, left: 0 };
    viewer.setInsets(insets);
    viewer.resize(box.width, box.height, devicePixelRatio);
    if (narrow !== isNarrow) viewer.fit(false);
    narrow = isNarrow;
  };
  const observer = new ResizeObserver(measure);
  observer.observe(stage);
  observer.observe(panel);
  measure();
}
