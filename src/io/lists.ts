/** Growing arrays. One class per element kind, so that each stays fast. */

const firstCapacity = 1024;

export class FloatList {
  #data = new Float64Array(firstCapacity);
  length = 0;

  push(value: number): void {
    if (this.length === this.#data.length) this.#grow(this.length + 1);
    this.#data[this.length++] = value;
  }

  push2(x: number, y: number): void {
    this.push(x);
    this.push(y);
  }

  push3(x: number, y: number, z: number): void {
    if (this.length + 3 > this.#data.length) this.#grow(this.length + 3);
    const data = this.#data;
    data[this.length] = x;
    data[this.length + 1] = y;
    data[this.length + 2] = z;
    this.length += 3;
  }

  /** A copy of the right length. */
  take(): Float64Array<ArrayBuffer> {
    return this.#data.slice(0, this.length);
  }

  #grow(needed: number): void {
    const larger = new Float64Array(Math.max(needed, 2 * this.#data.length));
    larger.set(this.#data);
    this.#data = larger;
  }
}

/** Texture coordinates of corners, #C×2, from those of vertices. */
export function uvsOfCorners(ofVertex: Float64Array, corners: Uint32Array): Float32Array<ArrayBuffer> {
  return new Float32Array(2 * corners.length).map((_, i) => ofVertex[2 * corners[i >> 1] + (i & 1)]);
}

/** Unsigned 32-bit integers: indices, byte offsets. */
export class IndexList {
  #data = new Uint32Array(firstCapacity);
  length = 0;

  push(value: number): void {
    if (this.length === this.#data.length) this.#grow();
    this.#data[this.length++] = value;
  }

  push3(a: number, b: number, c: number): void {
    this.push(a);
    this.push(b);
    this.push(c);
  }

  /** Appends `value` until there are `length` elements. */
  padTo(length: number, value: number): void {
    while (this.length < length) this.push(value);
  }

  /** A copy of the right length. */
  take(): Uint32Array<ArrayBuffer> {
    return this.#data.slice(0, this.length);
  }

  #grow(): void {
    const larger = new Uint32Array(2 * this.#data.length);
    larger.set(this.#data);
    this.#data = larger;
  }
}
