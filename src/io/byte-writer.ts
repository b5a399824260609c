/** Collects bytes: pieces of a source file and new ASCII text. */
export class ByteWriter {
  #data: Uint8Array<ArrayBuffer>;
  #length = 0;

  /** @param expected number of bytes to make room for */
  constructor(expected: number) {
    this.#data = new Uint8Array(Math.max(64, expected));
  }

  /** How many bytes there are so far. */
  get length(): number {
    return this.#length;
  }

  /** Appends `source[from, to)`. */
  copy(source: Uint8Array, from: number, to: number): void {
    if (to <= from) return;
    this.#reserve(to - from);
    this.#data.set(source.subarray(from, to), this.#length);
    this.#length += to - from;
  }

  /** Appends text whose characters are all ASCII. */
  ascii(text: string): void {
    this.#reserve(text.length);
    for (let i = 0; i < text.length; i++) this.#data[this.#length + i] = text.charCodeAt(i);
    this.#length += text.length;
  }

  take(): Uint8Array<ArrayBuffer> {
    return this.#data.slice(0, this.#length);
  }

  #reserve(extra: number): void {
    const needed = this.#length + extra;
    if (needed <= this.#data.length) return;
    const larger = new Uint8Array(Math.max(needed, Math.ceil(1.5 * this.#data.length)));
    larger.set(this.#data.subarray(0, this.#length));
    this.#data = larger;
  }
}
