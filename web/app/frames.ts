import type { Box } from '../../src/viewer/box.ts';

/** Between pictures side by side, in CSS pixels. */
const gap = 8;

/** Cuts a box into so many of one size, in the rows and columns that leave each the most room both ways, or one above the other. */
export function framesIn(free: Box, count: number, areStacked = false): readonly Box[] {
  let best = grid(free, count, 1);
  if (areStacked) return best;
  for (let columns = 2; columns <= count; columns++) {
    const next = grid(free, count, columns);
    if (room(next) > room(best)) best = next;
  }
  return best;
}

function room([first]: readonly Box[]): number {
  return first ? Math.min(first.width, first.height) : 0;
}

function grid({ left, top, ...free }: Box, count: number, columns: number): readonly Box[] {
  const rows = Math.ceil(count / columns);
  const width = (free.width - gap * (columns - 1)) / columns;
  const height = (free.height - gap * (rows - 1)) / rows;
  return Array.from({ length: count }, (_, k) => ({
    left: left + (k % columns) * (width + gap),
    top: top + Math.floor(k / columns) * (height + gap),
    width,
    height,
  }));
}
