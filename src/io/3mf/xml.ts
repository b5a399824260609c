import { decodeAscii } from '../bytes.ts';

const quotes = [34, 39];
const slash = 47;
const equals = 61;
const lessThan = 60;
const greaterThan = 62;
const colon = 58;

/**
 * Walks over the tags of an XML text, one after the other, and knows where the values of their attributes stand. Text between tags,
 * comments and declarations are passed over; prefixes of names are left out.
 */
export class XmlTags {
  readonly bytes: Uint8Array;
  /** The local name of the tag. */
  name = '';
  /** Whether it is an end tag. */
  isEnd = false;
  /** Whether it ends itself. */
  isEmpty = false;
  /** Where it begins. */
  start = 0;
  #at = 0;
  /** Of each attribute: begin and end of its local name, begin and end of its value. */
  readonly #spans: number[] = [];

  constructor(bytes: Uint8Array) {
    this.bytes = bytes;
  }

  /** Moves to the next tag. False at the end of the text, or where it breaks off. */
  next(): boolean {
    const { bytes } = this;
    for (;;) {
      const at = bytes.indexOf(lessThan, this.#at);
      if (at < 0 || at + 1 >= bytes.length) return false;
      if (bytes[at + 1] === 33 || bytes[at + 1] === 63) this.#at = this.#endOfRemark(at);
      else return this.#tag(at);
    }
  }

  /** The text of an attribute. */
  get(attribute: string): string | undefined {
    const span = this.span(attribute);
    return span && decodeText(this.bytes, span[0], span[1]);
  }

  /** The number in an attribute; NaN if there is none. */
  number(attribute: string): number {
    const span = this.span(attribute);
    if (!span || span[0] === span[1]) return Number.NaN;
    return Number(decodeAscii(this.bytes, span[0], span[1]));
  }

  /** Bytes [begin, end) of an attribute's value. */
  span(attribute: string): readonly [number, number] | undefined {
    const spans = this.#spans;
    for (let i = 0; i < spans.length; i += 4) {
      if (this.#isNamed(spans[i], spans[i + 1], attribute)) return [spans[i + 2], spans[i + 3]];
    }
    return undefined;
  }

  #isNamed(begin: number, end: number, name: string): boolean {
    if (end - begin !== name.length) return false;
    for (let i = 0; i < name.length; i++) if (this.bytes[begin + i] !== name.charCodeAt(i)) return false;
    return true;
  }

  #endOfRemark(at: number): number {
    const isComment = this.bytes[at + 2] === 45 && this.bytes[at + 3] === 45;
    let end = isComment ? at + 4 : at;
    while (end < this.bytes.length) {
      end = this.bytes.indexOf(greaterThan, end + 1);
      if (end < 0) return this.bytes.length;
      if (!isComment || (this.bytes[end - 1] === 45 && this.bytes[end - 2] === 45)) return end + 1;
    }
    return end;
  }

  #tag(start: number): boolean {
    const { bytes } = this;
    this.start = start;
    this.isEnd = bytes[start + 1] === slash;
    const begin = start + (this.isEnd ? 2 : 1);
    const end = this.#wordEnd(begin);
    this.name = decodeAscii(bytes, this.#localBegin(begin, end), end);
    this.#spans.length = 0;
    let at = end;
    for (;;) {
      while (bytes[at] <= 32) at++;
      if (at >= bytes.length) return false;
      if (bytes[at] === greaterThan) break;
      if (bytes[at] === slash) {
        at++;
        continue;
      }
      at = this.#attribute(at);
      if (at < 0) return false;
    }
    this.isEmpty = bytes[at - 1] === slash;
    this.#at = at + 1;
    return true;
  }

  /** @returns the byte behind the attribute, or −1 where the text breaks off */
  #attribute(begin: number): number {
    const { bytes } = this;
    const end = this.#wordEnd(begin);
    let at = end;
    while (bytes[at] <= 32) at++;
    if (bytes[at] !== equals) return at > begin ? at : -1;
    at++;
    while (bytes[at] <= 32) at++;
    if (!quotes.includes(bytes[at])) return -1;
    const close = bytes.indexOf(bytes[at], at + 1);
    if (close < 0) return -1;
    this.#spans.push(this.#localBegin(begin, end), end, at + 1, close);
    return close + 1;
  }

  #wordEnd(begin: number): number {
    const { bytes } = this;
    let at = begin;
    while (
      at < bytes.length &&
      bytes[at] > 32 &&
      bytes[at] !== equals &&
      bytes[at] !== greaterThan &&
      bytes[at] !== slash
    )
      at++;
    return at;
  }

  #localBegin(begin: number, end: number): number {
    for (let at = begin; at < end; at++) if (this.bytes[at] === colon) return at + 1;
    return begin;
  }
}

const entities: Readonly<Record<string, string>> = { amp: '&', lt: '<', gt: '>', quot: '"', apos: "'" };

function decodeText(bytes: Uint8Array, begin: number, end: number): string {
  const text = new TextDecoder().decode(bytes.subarray(begin, end));
  return text.replaceAll(/&(amp|lt|gt|quot|apos);/g, (_, name: string) => entities[name]);
}
