import type { ScreenPoint } from './near-pointer.ts';

/** An area of the screen that takes the vertices in it. */
export interface ScreenRegion {
  /** In CSS pixels; a lasso is closed by itself, and what it goes around twice is inside as well. */
  readonly outline: readonly ScreenPoint[];
}

/** The rectangle between two corners. */
export function boxRegion([ax, ay]: ScreenPoint, [bx, by]: ScreenPoint): ScreenRegion {
  return { outline: [[ax, ay], [bx, ay], [bx, by], [ax, by]] }; // biome-ignore format: the corners in a row
}

/** Rows into which a lasso is cut, so that each vertex is held against the few lines beside it. */
const rows = 256;

interface Line {
  readonly x: number;
  readonly y: number;
  readonly toX: number;
  readonly toY: number;
}

/**
 * The vertices whose places on the screen lie in a region.
 *
 * @param places #V×2 CSS pixels; NaN for what is not on the screen
 * @param isVisible asked of those inside alone. Default: all are, so that the far side is taken too
 */
export function verticesInside(
  { outline }: ScreenRegion,
  places: ArrayLike<number>,
  isVisible: (vertex: number) => boolean = () => true,
): Uint32Array {
  const [left, top, right, bottom] = boundsOf(outline);
  const linesOf = cutIntoRows(outline, top, bottom);
  const found: number[] = [];
  for (let v = 0; 2 * v < places.length; v++) {
    const x = places[2 * v]!;
    const y = places[2 * v + 1]!;
    // Written so that NaN is outside.
    if (!(x >= left && x <= right && y >= top && y <= bottom)) continue;
    const lines = linesOf[rowOf(y, top, bottom)]!;
    if (windingNumber(lines, x, y) !== 0 && isVisible(v)) found.push(v);
  }
  return Uint32Array.from(found);
}

function boundsOf(outline: readonly ScreenPoint[]): [number, number, number, number] {
  let [left, top, right, bottom] = [Infinity, Infinity, -Infinity, -Infinity];
  for (const [x, y] of outline) {
    left = Math.min(left, x);
    right = Math.max(right, x);
    top = Math.min(top, y);
    bottom = Math.max(bottom, y);
  }
  return [left, top, right, bottom];
}

function rowOf(y: number, top: number, bottom: number): number {
  return bottom > top ? Math.min(rows - 1, Math.floor(((y - top) / (bottom - top)) * rows)) : 0;
}

function cutIntoRows(outline: readonly ScreenPoint[], top: number, bottom: number): Line[][] {
  const cut: Line[][] = Array.from({ length: rows }, () => []);
  outline.forEach(([x, y], i) => {
    const [toX, toY] = outline[(i + 1) % outline.length]!;
    const first = rowOf(Math.min(y, toY), top, bottom);
    const last = rowOf(Math.max(y, toY), top, bottom);
    for (let row = first; row <= last; row++) cut[row]!.push({ x, y, toX, toY });
  });
  return cut;
}

/** How often the lines go around a place; a line counts where it passes the place's height on its right. */
function windingNumber(lines: readonly Line[], x: number, y: number): number {
  let winding = 0;
  for (const line of lines) {
    const isUpward = line.y > y && line.toY <= y;
    const isDownward = line.y <= y && line.toY > y;
    if (!isUpward && !isDownward) continue;
    const at = line.x + ((y - line.y) / (line.toY - line.y)) * (line.toX - line.x);
    if (at > x) winding += isUpward ? 1 : -1;
  }
  return winding;
}
