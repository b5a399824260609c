import type { Viewer } from '../../src/viewer/viewer.ts';

/** Keeps the canvas as large as its box and the object centred in the part that no panel covers. */
export function followLayout(
  viewer: Viewer,
  stage: HTMLElement,
  { panel, bar, strip, options }: Record<'panel' | 'bar' | 'strip' | 'options', HTMLElement>,
): void {
  let narrow: boolean | null = null;
  let covered = 0;
  const measure = () => {
    const box = stage.getBoundingClientRect();
    const cover = panel.getBoundingClientRect();
    const isNarrow = matchMedia('(max-width: 760px)').matches;
    // On a phone the tool's options stand on the sheet, of which only the way home is left then.
    const sheet = cover.height + (isNarrow ? options.getBoundingClientRect().height : 0);
    stage.style.setProperty('--home-height', `${cover.height}px`);
    stage.style.setProperty('--sheet-height', `${sheet}px`);
    const insets = isNarrow
      ? { top: 84, right: 0, bottom: Math.max(0, box.bottom - bar.getBoundingClientRect().top), left: 0 }
      : {
          top: 64,
          right: Math.max(0, box.right - cover.left),
          bottom: 48,
          left: Math.max(...[strip, options].map((one) => one.getBoundingClientRect().right - box.left)),
        };
    viewer.setInsets(insets);
    viewer.resize(box.width, box.height, devicePixelRatio);
    // Where the sheet takes much more or less of a phone than before, the object moves to where it can be seen.
    const isOther = isNarrow && Math.abs(covered - insets.bottom) > 60;
    if (narrow !== isNarrow) viewer.fit(false);
    else if (isOther) viewer.fit();
    else if (!isNarrow) viewer.uncover();
    if (narrow !== isNarrow || isOther) covered = insets.bottom;
    narrow = isNarrow;
  };
  const observer = new ResizeObserver(measure);
  observer.observe(stage);
  observer.observe(panel);
  observer.observe(strip);
  observer.observe(options);
  measure();
}
