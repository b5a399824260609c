/**
 * Where a text stops being JSON, as a line from 1. Engines word their errors differently and some leave the place out, so
 * this looks for itself; the text is known to be broken.
 */
export function lineOfJsonError(text: string): number {
  const scanner = new Scanner(text);
  scanner.document();
  return text.slice(0, scanner.position).split('\n').length;
}

const literal = /true|false|null|-?(?:0|[1-9]\d*)(?:\.\d+)?(?:[eE][+-]?\d+)?/y;
// biome-ignore lint/suspicious/noControlCharactersInRegex: JSON strings may not hold them, that is the point
const string = /"(?:[^"\\\u0000-\u001f]|\\(?:["\\/bfnrt]|u[0-9a-fA-F]{4}))*"/y;
const space = /[ \t\r\n]*/y;

/** Recursive descent over JSON; every method says whether it could go on, `position` is as far as it came. */
class Scanner {
  readonly #text: string;
  position = 0;

  constructor(text: string) {
    this.#text = text;
  }

  /** A value and nothing after it but space. */
  document(): boolean {
    return this.value() && this.#take(space);
  }

  value(): boolean {
    this.#take(space);
    if (this.#takes('{')) return this.#list('}', () => this.#entry());
    if (this.#takes('[')) return this.#list(']', () => this.value());
    return this.#take(string) || this.#take(literal);
  }

  #entry(): boolean {
    this.#take(space);
    if (!this.#take(string)) return false;
    this.#take(space);
    return this.#takes(':') && this.value();
  }

  #list(end: string, item: () => boolean): boolean {
    this.#take(space);
    if (this.#takes(end)) return true;
    for (;;) {
      if (!item()) return false;
      this.#take(space);
      if (this.#takes(end)) return true;
      if (!this.#takes(',')) return false;
    }
  }

  #takes(character: string): boolean {
    if (this.#text[this.position] !== character) return false;
    this.position++;
    return true;
  }

  #take(pattern: RegExp): boolean {
    pattern.lastIndex = this.position;
    const match = pattern.exec(this.#text)?.[0];
    if (match === undefined) return false;
    this.position += match.length;
    return true;
  }
}
