/** Where a box lies, as much as walking needs. */
export interface Box {
  readonly left: number;
  readonly top: number;
}

/**
 * Where an arrow key leads among boxes in rows: left and right along the reading order, up and down to the nearest box of the
 * next row (in a single row to the neighbour). Null for other keys.
 */
export function stepInGrid(boxes: readonly Box[], here: number, key: string): number | null {
  const last = boxes.length - 1;
  const from = boxes[here];
  if (!from) return null;
  switch (key) {
    case 'ArrowRight':
      return Math.min(last, here + 1);
    case 'ArrowLeft':
      return Math.max(0, here - 1);
    case 'Home':
      return 0;
    case 'End':
      return last;
    case 'ArrowDown':
      return nextRow(boxes, from, 1) ?? Math.min(last, here + (isOneRow(boxes) ? 1 : 0));
    case 'ArrowUp':
      return nextRow(boxes, from, -1) ?? Math.max(0, here - (isOneRow(boxes) ? 1 : 0));
    default:
      return null;
  }
}

function nextRow(boxes: readonly Box[], from: Box, way: 1 | -1): number | null {
  const beyond = boxes.filter(({ top }) => way * (top - from.top) > 1);
  if (beyond.length === 0) return null;
  const rowTop = way * Math.min(...beyond.map(({ top }) => way * top));
  const row = beyond.filter(({ top }) => Math.abs(top - rowTop) <= 1);
  const off = ({ left }: Box): number => Math.abs(left - from.left);
  const nearest = row.reduce((best, box) => (off(box) < off(best) ? box : best));
  return boxes.indexOf(nearest);
}

function isOneRow(boxes: readonly Box[]): boolean {
  return boxes.every(({ top }) => Math.abs(top - boxes[0]!.top) <= 1);
}
