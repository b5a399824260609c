import { deflateSync, inflateSync } from 'fflate';
import { ByteWriter } from './byte-writer.ts';
import { decodeAscii, encodeUtf8, viewOf } from './bytes.ts';
import { crc32 } from './crc32.ts';
import { quote, refusal } from './refuse.ts';

/** One file of a zip archive, packed as it is. */
export interface ZipEntry {
  readonly name: string;
  /** How it is packed: 0 stored, 8 deflated. */
  readonly method: number;
  readonly size: number;
  readonly packed: Uint8Array;
  /** Its record in the archive's directory, from which all else is taken over. */
  readonly record: Uint8Array;
}

const endMark = 0x06054b50;
const recordMark = 0x02014b50;
const fileMark = 0x04034b50;
const endLength = 22;
const recordLength = 46;
const fileLength = 30;
/** In a record's flags: its name is UTF-8. */
const utf8Flag = 0x800;
export const stored = 0;
export const deflated = 8;
/** More than this does not come out of one file. */
const mostBytes = 2 ** 31 - 1;
/** Deflated data cannot unfold to more times its length. */
const mostUnfolding = 1040;

/** Whether bytes begin as a zip archive does. */
export function isZip(bytes: Uint8Array): boolean {
  return bytes.length >= 4 && viewOf(bytes).getUint32(0, true) === fileMark;
}

/** The files of an archive, by its directory. @throws truncated-file, unsupported-file */
export function readZip(bytes: Uint8Array, name: string): ZipEntry[] {
  const cutOff = (at: number) =>
    refusal('truncated-file', name, `byte ${at}`, 'the archive is broken or cut off; get it again.');
  const view = viewOf(bytes);
  const end = endOfDirectory(view);
  if (end < 0) throw cutOff(bytes.length);
  const count = view.getUint16(end + 10, true);
  let at = view.getUint32(end + 16, true);
  if (count === 0xffff || at === 0xffffffff) {
    throw refusal('unsupported-file', name, '', 'it is a zip64 archive, which is not read; pack it again.');
  }
  const entries: ZipEntry[] = [];
  for (let i = 0; i < count; i++) {
    if (at + recordLength > end || view.getUint32(at, true) !== recordMark) throw cutOff(at);
    const lengths = [28, 30, 32].map((offset) => view.getUint16(at + offset, true));
    const next = at + recordLength + lengths.reduce((sum, length) => sum + length, 0);
    if (next > end) throw cutOff(at);
    const record = bytes.subarray(at, next);
    entries.push(entryOf(bytes, record, lengths[0], () => cutOff(at)));
    at = next;
  }
  return entries;
}

/** The bytes of a file. @throws malformed-file, too-large, unsupported-file */
export function unpack(entry: ZipEntry, archive: string): Uint8Array {
  const { name, method, size, packed } = entry;
  const place = quote(name);
  if (method !== stored && method !== deflated) {
    throw refusal(
      'unsupported-file',
      archive,
      place,
      'it is packed in a way that is not read; pack it again.',
    );
  }
  if (size > mostBytes) {
    throw refusal('too-large', archive, place, 'it unfolds to more than 2 GB; split the model.');
  }
  const bytes = method === stored ? packed : inflated(entry);
  // The record tells what the sum is to be.
  if (bytes?.length === size && crc32(bytes) === viewOf(entry.record).getUint32(16, true)) return bytes;
  throw refusal('malformed-file', archive, place, 'its data is broken; get the file again.');
}

function inflated({ size, packed }: ZipEntry): Uint8Array | undefined {
  if (size > mostUnfolding * packed.length) return undefined;
  try {
    return inflateSync(packed, { out: new Uint8Array(size) });
  } catch {
    return undefined;
  }
}

/** The archive with other contents of some of its files; the others stay packed as they are. */
export function repackZip(
  entries: readonly ZipEntry[],
  contents: ReadonlyMap<string, Uint8Array>,
): Uint8Array<ArrayBuffer> {
  const writer = new ByteWriter(entries.reduce((sum, { packed }) => sum + packed.length + 200, 0));
  const directory = entries.map((entry) => {
    const offset = writer.length;
    const content = contents.get(entry.name);
    const packed = content ? deflateSync(content) : entry.packed;
    const record = entry.record.slice();
    const view = viewOf(record);
    // Sizes stand in the header here, and not behind the data.
    view.setUint16(8, view.getUint16(8, true) & ~8, true);
    if (content) {
      view.setUint16(10, deflated, true);
      view.setUint32(16, crc32(content), true);
      view.setUint32(24, content.length, true);
    }
    view.setUint32(20, packed.length, true);
    view.setUint32(42, offset, true);
    copy(writer, fileHeader(record));
    copy(writer, packed);
    return record;
  });
  const begin = writer.length;
  for (const record of directory) copy(writer, record);
  copy(writer, endRecord(directory.length, begin, writer.length - begin));
  return writer.take();
}

/** A new archive. */
export function makeZip(files: ReadonlyMap<string, Uint8Array>): Uint8Array<ArrayBuffer> {
  const nothing = new Uint8Array();
  const entries = [...files.keys()].map((name) =>
    newEntry(name, { method: deflated, size: 0, sum: 0, packed: nothing }),
  );
  return repackZip(entries, files);
}

/** What a file of a new archive holds. */
export interface ZipContent extends Pick<ZipEntry, 'method' | 'size' | 'packed'> {
  /** The check sum of what is packed. */
  readonly sum: number;
}

/** A file of a new archive, on the first day that such dates know. */
export function newEntry(name: string, { method, size, sum, packed }: ZipContent): ZipEntry {
  const text = encodeUtf8(name);
  const record = new Uint8Array(recordLength + text.length);
  const view = viewOf(record);
  view.setUint32(0, recordMark, true);
  view.setUint16(4, 20, true);
  view.setUint16(6, 20, true);
  if (text.length > name.length) view.setUint16(8, utf8Flag, true);
  view.setUint16(10, method, true);
  view.setUint16(14, 0x21, true);
  view.setUint32(16, sum, true);
  view.setUint32(24, size, true);
  view.setUint16(28, text.length, true);
  record.set(text, recordLength);
  return { name, method, size, packed, record };
}

/** The directory's end stands at the end of the file, but for a remark behind it. */
function endOfDirectory(view: DataView): number {
  const first = Math.max(0, view.byteLength - endLength - 0xffff);
  for (let at = view.byteLength - endLength; at >= first; at--)
    if (view.getUint32(at, true) === endMark) return at;
  return -1;
}

function entryOf(bytes: Uint8Array, record: Uint8Array, nameLength: number, cutOff: () => Error): ZipEntry {
  const view = viewOf(record);
  const file = viewOf(bytes);
  const at = view.getUint32(42, true);
  if (at + fileLength > bytes.length || file.getUint32(at, true) !== fileMark) throw cutOff();
  const begin = at + fileLength + file.getUint16(at + 26, true) + file.getUint16(at + 28, true);
  const length = view.getUint32(20, true);
  if (begin + length > bytes.length) throw cutOff();
  return {
    name: nameOf(record, nameLength),
    method: view.getUint16(10, true),
    size: view.getUint32(24, true),
    packed: bytes.subarray(begin, begin + length),
    record,
  };
}

/** UTF-8 where the record says so. */
function nameOf(record: Uint8Array, length: number): string {
  const isUtf8 = (viewOf(record).getUint16(8, true) & utf8Flag) !== 0;
  if (!isUtf8) return decodeAscii(record, recordLength, recordLength + length);
  return new TextDecoder().decode(record.subarray(recordLength, recordLength + length));
}

/** What stands before a file's data: the beginning of its record, without remarks and places. */
function fileHeader(record: Uint8Array): Uint8Array {
  const nameLength = viewOf(record).getUint16(28, true);
  const header = new Uint8Array(fileLength + nameLength);
  viewOf(header).setUint32(0, fileMark, true);
  header.set(record.subarray(6, 28), 4);
  viewOf(header).setUint16(26, nameLength, true);
  header.set(record.subarray(recordLength, recordLength + nameLength), fileLength);
  return header;
}

function endRecord(count: number, begin: number, length: number): Uint8Array {
  const record = new Uint8Array(endLength);
  const view = viewOf(record);
  view.setUint32(0, endMark, true);
  view.setUint16(8, count, true);
  view.setUint16(10, count, true);
  view.setUint32(12, length, true);
  view.setUint32(16, begin, true);
  return record;
}

function copy(writer: ByteWriter, bytes: Uint8Array): void {
  writer.copy(bytes, 0, bytes.length);
}
