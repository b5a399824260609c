import { heightOfWhite, type Texture, textureOfHeights } from './texture.ts';

/** Images of our own. Each is a rule: a height from 0 to 1 for a place of the unit square, which meets itself at its edges. */
type Rule = (u: number, v: number) => number;

const side = 512;

/** Threads over and under each other, eight each way. */
const weave: Rule = (u, v) => {
  const [x, y] = [8 * u, 8 * v];
  /** Height of a thread: round across, and along it up at one crossing and down at the next. */
  const thread = (across: number, along: number, phase: number): number => {
    const round = Math.sqrt(Math.max(0, 1 - (2 * fraction(across) - 1) ** 2));
    const lift = 0.5 + 0.5 * Math.cos(Math.PI * (along - 0.5 + Math.floor(across) + phase));
    return round * (0.3 + 0.7 * lift);
  };
  return Math.max(thread(x, y, 0), thread(y, x, 1));
};

/** Round scales in rows, each row half covered by the one above and half a scale aside. */
const scales: Rule = (u, v) => {
  const [columns, rows] = [6, 10];
  const y = rows * v;
  let top = 0;
  for (let row = Math.floor(y) - 1; row <= Math.floor(y) + 2; row++) {
    const dx = 2 * fraction(columns * u + mod(row, 2) / 2) - 1;
    const up = (y - row + 1) / 2; // 0 at the tip of the scale, 1 where it grows from
    const edge = 0.5 - 0.5 * Math.sqrt(Math.max(0, 1 - dx * dx));
    if (up < edge || up > 1) continue;
    // Highest near the tip, with a rounded edge, and domed across.
    const rim = Math.min(1, (up - edge) / 0.12);
    top = Math.max(top, Math.sqrt(rim * (2 - rim)) * (1 - 0.62 * up) * (0.75 + 0.25 * (1 - dx * dx)));
  }
  return top;
};

/** Dents of a hammer on sheet metal: a bowl around each of some scattered points. */
const hammered: Rule = (u, v) => {
  const cells = 7;
  const [x, y] = [cells * u, cells * v];
  let nearest = 2;
  for (let j = -2; j <= 2; j++)
    for (let i = -2; i <= 2; i++) {
      const [ci, cj] = [Math.floor(x) + i, Math.floor(y) + j];
      const px = ci + 0.5 + 0.4 * scatter(mod(ci, cells), mod(cj, cells), 0);
      const py = cj + 0.5 + 0.4 * scatter(mod(ci, cells), mod(cj, cells), 1);
      nearest = Math.min(nearest, (x - px) ** 2 + (y - py) ** 2);
    }
  return Math.min(1, nearest);
};

const rules: Readonly<Record<string, Rule>> = { weave, scales, hammered };

export const patternIds: readonly string[] = Object.keys(rules);

const made = new Map<string, Texture>();

/** A pattern by its name, or undefined if there is none of it. */
export function findPattern(id: string): Texture | undefined {
  const rule = Object.hasOwn(rules, id) ? rules[id] : undefined;
  if (!rule) return undefined;
  const texture = made.get(id) ?? textureOfHeights(side, side, heightsOf(rule));
  made.set(id, texture);
  return texture;
}

function heightsOf(rule: Rule): Float64Array {
  return new Float64Array(side * side).map((_, pixel) => {
    const [i, j] = [pixel % side, Math.floor(pixel / side)];
    return heightOfWhite * rule((i + 0.5) / side, 1 - (j + 0.5) / side);
  });
}

function fraction(x: number): number {
  return x - Math.floor(x);
}

function mod(a: number, n: number): number {
  return ((a % n) + n) % n;
}

/** From −1 to 1, without order to the eye and the same every time. */
function scatter(i: number, j: number, k: number): number {
  let mixed = Math.imul(i + 1, 0x9e3779b1) ^ Math.imul(j + 1, 0x85ebca6b) ^ Math.imul(k + 1, 0xc2b2ae35);
  mixed = Math.imul(mixed ^ (mixed >>> 15), 0x2c1b3c6d);
  mixed = Math.imul(mixed ^ (mixed >>> 12), 0x297a2d39);
  return ((mixed ^ (mixed >>> 15)) >>> 0) / 0x7fffffff - 1;
}
