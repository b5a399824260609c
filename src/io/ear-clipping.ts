/**
 * Splits a counter-clockwise polygon in the plane into n − 2 triangles by clipping ears. Only corners that turn right can
 * lie in an ear, so only those are tested. Worst case O(n²); `budget` bounds it.
 *
 * @param flat #n×2 corners; longer arrays are fine
 * @param budget number of point-in-triangle tests after which the rest is split as a fan (`complete` is false then)
 */
export function clipEars(
  flat: Float64Array,
  n: number,
  budget: number,
): { triangles: Uint32Array; tests: number; complete: boolean } {
  const ring = new Ring(flat, n);
  const triangles = new Uint32Array(3 * (n - 2));
  let length = 0;
  let corner = 0;
  let missed = 0;
  let left = n;
  while (left > 3 && ring.tests < budget) {
    const after = ring.next[corner];
    // A tangled polygon may have no ear at all; then any corner goes.
    if (missed <= left && !ring.isEar(corner)) {
      missed++;
      corner = after;
      continue;
    }
    triangles.set([ring.previous[corner], corner, after], length);
    length += 3;
    ring.remove(corner);
    missed = 0;
    corner = ring.next[after]; // skipping one gives rounder triangles
    if ((--left & 15) === 0) ring.updateReflex();
  }
  for (let b = ring.next[corner]; ring.next[b] !== corner; b = ring.next[b]) {
    triangles.set([corner, b, ring.next[b]], length);
    length += 3;
  }
  return { triangles, tests: ring.tests, complete: left === 3 };
}

/** Corners that are left, linked to their neighbours. */
class Ring {
  readonly next: Uint32Array;
  readonly previous: Uint32Array;
  tests = 0;
  readonly #flat: Float64Array;
  readonly #gone: Uint8Array;
  /** Corners that turned right, or not at all, when last looked at. A corner never turns back from left to right. */
  readonly #reflex: Uint32Array;
  #reflexCount = 0;

  constructor(flat: Float64Array, n: number) {
    this.#flat = flat;
    this.#gone = new Uint8Array(n);
    this.next = new Uint32Array(n);
    this.previous = new Uint32Array(n);
    for (let i = 0; i < n; i++) {
      this.next[i] = i + 1 === n ? 0 : i + 1;
      this.previous[i] = i === 0 ? n - 1 : i - 1;
    }
    this.#reflex = new Uint32Array(n);
    for (let i = 0; i < n; i++) if (this.#isReflex(i)) this.#reflex[this.#reflexCount++] = i;
  }

  remove(corner: number): void {
    this.#gone[corner] = 1;
    this.next[this.previous[corner]] = this.next[corner];
    this.previous[this.next[corner]] = this.previous[corner];
  }

  /** Forgets corners that are gone or turn left by now. */
  updateReflex(): void {
    this.tests += this.#reflexCount;
    let kept = 0;
    for (let k = 0; k < this.#reflexCount; k++) {
      const i = this.#reflex[k];
      if (this.#gone[i] === 0 && this.#isReflex(i)) this.#reflex[kept++] = i;
    }
    this.#reflexCount = kept;
  }

  /** Whether the corner turns left and its triangle holds no reflex corner, those at its own places not counted. */
  isEar(b: number): boolean {
    const a = this.previous[b];
    const c = this.next[b];
    this.tests++;
    if (!(this.#area(a, b, c) > 0)) return false;
    for (let k = 0; k < this.#reflexCount; k++) {
      const i = this.#reflex[k];
      this.tests++;
      if (this.#area(a, b, i) < 0 || this.#area(b, c, i) < 0 || this.#area(c, a, i) < 0) continue;
      // Corners in the same place are where a hole is bridged to the outline.
      if (this.#gone[i] === 0 && !this.#same(i, a) && !this.#same(i, b) && !this.#same(i, c)) return false;
    }
    return true;
  }

  #isReflex(i: number): boolean {
    return !(this.#area(this.previous[i], i, this.next[i]) > 0);
  }

  #same(i: number, j: number): boolean {
    const x = this.#flat;
    return x[2 * i] === x[2 * j] && x[2 * i + 1] === x[2 * j + 1];
  }

  /** Twice the signed area of a triangle. */
  #area(a: number, b: number, c: number): number {
    const x = this.#flat;
    const ax = x[2 * a];
    const ay = x[2 * a + 1];
    return (x[2 * b] - ax) * (x[2 * c + 1] - ay) - (x[2 * b + 1] - ay) * (x[2 * c] - ax);
  }
}
