import { type UnzipFileInfo, unzipSync } from 'fflate';
import { nameOfPath } from '../../src/io/index.ts';

/** A file that was dropped or picked, or lay in a folder or a zip archive of these. */
export interface FoundFile {
  readonly name: string;
  /** Its way from what was dropped: "house/textures/wood.png". */
  readonly path: string;
  arrayBuffer(): Promise<ArrayBuffer>;
}

/** More than this is no model, but somebody's disk. */
const mostFiles = 5000;
const mostBytes = 2 ** 31;

/** The files of a drop, those in folders too. To be called while the event is handled: later its items are gone. */
export function filesOfDrop(transfer: DataTransfer): Promise<FoundFile[]> {
  const entries = [...transfer.items].map((item) => item.webkitGetAsEntry?.() ?? null);
  const files = [...transfer.files];
  if (!entries.some((entry) => entry?.isDirectory)) return Promise.resolve(files.map((file) => found(file)));
  return filesOfEntries(entries);
}

/** Archives are replaced by what is in them. @throws Error for an archive that is broken */
export async function unpackArchives(files: readonly FoundFile[]): Promise<readonly FoundFile[]> {
  if (!files.some(({ name }) => isArchive(name))) return files;
  const lists = await Promise.all(
    files.map((file) => (isArchive(file.name) ? filesOfArchive(file) : [file])),
  );
  return lists.flat();
}

/** Finds the files that one of several refers to: by their paths from its folder, or else by their names. */
export function beside(
  file: FoundFile,
  files: readonly FoundFile[],
): (path: string) => FoundFile | undefined {
  return (path) => {
    const whole = joined(folderOf(file.path), path).toLowerCase();
    return (
      files.find((other) => other.path.toLowerCase() === whole) ??
      files.find((other) => other.name.toLowerCase() === path.toLowerCase())
    );
  };
}

/** What {@link beside} finds, read. */
export function readBeside(
  file: FoundFile,
  files: readonly FoundFile[],
): (path: string) => Promise<Uint8Array<ArrayBuffer> | undefined> {
  const find = beside(file, files);
  return async (path) => {
    const match = find(path);
    return match && new Uint8Array(await match.arrayBuffer());
  };
}

export function found(file: File, path = file.webkitRelativePath || file.name): FoundFile {
  return { name: file.name, path, arrayBuffer: () => file.arrayBuffer() };
}

async function filesOfEntries(entries: readonly (FileSystemEntry | null)[]): Promise<FoundFile[]> {
  const files: FoundFile[] = [];
  const waiting = entries.filter((entry) => entry !== null);
  for (let entry = waiting.shift(); entry && files.length < mostFiles; entry = waiting.shift()) {
    if (entry.isDirectory) waiting.push(...(await entriesOf(entry as FileSystemDirectoryEntry)));
    else files.push(found(await fileOf(entry as FileSystemFileEntry), entry.fullPath.replace(/^\//, '')));
  }
  return files.filter(({ path }) => !isHidden(path));
}

/** A directory gives its entries a hundred at a time, and none at the end. */
async function entriesOf(directory: FileSystemDirectoryEntry): Promise<FileSystemEntry[]> {
  const reader = directory.createReader();
  const entries: FileSystemEntry[] = [];
  for (;;) {
    const some = await new Promise<FileSystemEntry[]>((resolve, reject) =>
      reader.readEntries(resolve, reject),
    );
    if (some.length === 0) return entries;
    entries.push(...some);
  }
}

function fileOf(entry: FileSystemFileEntry): Promise<File> {
  return new Promise((resolve, reject) => entry.file(resolve, reject));
}

async function filesOfArchive(archive: FoundFile): Promise<FoundFile[]> {
  const bytes = new Uint8Array(await archive.arrayBuffer());
  let unpacked = 0;
  const filter = ({ name, originalSize }: UnzipFileInfo) => {
    if (isHidden(name) || name.endsWith('/')) return false;
    unpacked += originalSize;
    if (unpacked > mostBytes) throw new Error('it holds more than 2 GB');
    return true;
  };
  try {
    return Object.entries(unzipSync(bytes, { filter })).map(([path, data]) => ({
      ...{ name: nameOfPath(path), path },
      arrayBuffer: async () => data.slice().buffer,
    }));
  } catch (thrown) {
    const why = thrown instanceof Error ? thrown.message : String(thrown);
    throw new Error(
      `${archive.name} could not be unpacked (${why}); unpack it yourself and drop what is in it.`,
    );
  }
}

function isArchive(name: string): boolean {
  return /\.zip$/i.test(name);
}

/** What systems put into folders and archives for themselves. */
function isHidden(path: string): boolean {
  return /(^|\/)(\.|__MACOSX\/)/.test(path);
}

function folderOf(path: string): string {
  return path.slice(0, path.lastIndexOf('/') + 1);
}

/** A path from a folder, with “..” taken out. */
function joined(folder: string, path: string): string {
  const parts: string[] = [];
  for (const part of `${folder}${path}`.split('/')) {
    if (part === '..') parts.pop();
    else if (part !== '.') parts.push(part);
  }
  return parts.join('/');
}
