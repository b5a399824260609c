import { type FilesBeside, nameOfPath } from './beside.ts';
import { encodeUtf8 } from './bytes.ts';
import { crc32 } from './crc32.ts';
import { isMeshFileName } from './formats.ts';
import { quote, refusal } from './refuse.ts';
import { deflated, isZip, newEntry, readZip, repackZip, stored, unpack, type ZipEntry } from './zip.ts';

/**
 * A project in one file, a zip archive that is of use unpacked too:
 *
 *     recipe.json        the steps that are on
 *     oloid.obj …        what the recipe names, under these names
 *     mesh/rabbit.glb    the mesh as it came, and beside it the files that it refers to
 *     project.json       what a page knows besides; nothing else needs it
 */
export interface ProjectFile {
  readonly mesh: { readonly name: string; readonly bytes: Uint8Array<ArrayBuffer> };
  /** Files that the mesh refers to. */
  readonly beside: FilesBeside;
  /** JSON; absent where no step is on. */
  readonly recipe?: string;
  /** JSON; absent in a file that was put together by hand. */
  readonly workspace?: string;
  /** The files that the recipe names, by these names. */
  readonly assets: ReadonlyMap<string, Uint8Array<ArrayBuffer>>;
}

const recipeName = 'recipe.json';
const workspaceName = 'project.json';
const meshFolder = 'mesh/';

/** Whether a file that a recipe names can lie beside it under that name: inside the project's folder, and not in another's place. */
export function fitsInProject(name: string): boolean {
  return isInside(name) && name !== recipeName && name !== workspaceName && !name.startsWith(meshFolder);
}

/** Whether a path leads downwards from a folder, on any system. */
function isInside(path: string): boolean {
  return !/^[a-z]:|\\|(^|\/)(\.\.?)?(\/|$)/i.test(path);
}

/** Packed already, as far as it goes. */
const dense = /\.(png|jpe?g|webp|ktx2|3mf|zip)$/i;

/** Packs a project, beside whatever else goes on. The same project gives the same bytes. */
export async function packProject(project: ProjectFile): Promise<Uint8Array<ArrayBuffer>> {
  const entries: ZipEntry[] = [];
  for (const [name, bytes] of filesOf(project)) {
    const sum = await checkSum(bytes);
    const packed = dense.test(name) ? bytes : await deflate(bytes);
    const method = packed === bytes ? stored : deflated;
    entries.push(newEntry(name, { method, size: bytes.length, sum, packed }));
  }
  return repackZip(entries, new Map());
}

async function deflate(bytes: Uint8Array<ArrayBuffer>): Promise<Uint8Array> {
  const packed = new Blob([bytes]).stream().pipeThrough(new CompressionStream('deflate-raw'));
  const whole = await new Response(packed).arrayBuffer();
  return new Uint8Array(whole);
}

/** Bytes that are summed in one go: so long the page stands still. */
const pieceLength = 2 ** 23;

async function checkSum(bytes: Uint8Array): Promise<number> {
  let sum = 0;
  for (let at = 0; at < bytes.length; at += pieceLength) {
    if (at > 0) await new Promise((resolve) => setTimeout(resolve));
    sum = crc32(bytes.subarray(at, at + pieceLength), sum);
  }
  return sum;
}

/** Whether bytes are those of a project. */
export function isProjectFile(bytes: Uint8Array): boolean {
  if (!isZip(bytes)) return false;
  try {
    return rootOf(readZip(bytes, '')) !== undefined;
  } catch {
    return false;
  }
}

/** @throws WhittleError truncated-file, malformed-file, too-large, unsupported-file; the sentence begins with the name */
export function unpackProject(bytes: Uint8Array, name: string): ProjectFile {
  const entries = readZip(bytes, name);
  const root = rootOf(entries);
  if (root === undefined) {
    throw refusal('unsupported-file', name, '', `no project is in it: there is no ${quote(recipeName)}.`);
  }
  const files = new Map<string, ZipEntry>();
  for (const entry of entries)
    if (entry.name.startsWith(root) && !entry.name.endsWith('/'))
      files.set(entry.name.slice(root.length), entry);
  const text = (file: string) => {
    const entry = files.get(file);
    return entry && new TextDecoder().decode(unpack(entry, name));
  };
  const workspace = text(workspaceName);
  const recipe = text(recipeName);
  const mesh = meshIn([...files.keys()], workspace);
  if (mesh === undefined) {
    throw refusal('unsupported-file', name, '', `it holds no mesh in the folder ${quote(meshFolder)}.`);
  }
  const beside = new Map<string, Uint8Array<ArrayBuffer>>();
  const assets = new Map<string, Uint8Array<ArrayBuffer>>();
  for (const [path, entry] of files) {
    if (path.startsWith(meshFolder) && path !== mesh)
      beside.set(path.slice(meshFolder.length), own(unpack(entry, name)));
    if (fitsInProject(path)) assets.set(path, own(unpack(entry, name)));
  }
  return {
    mesh: { name: nameOfPath(mesh), bytes: own(unpack(files.get(mesh)!, name)) },
    beside,
    assets,
    ...(recipe === undefined ? {} : { recipe }),
    ...(workspace === undefined ? {} : { workspace }),
  };
}

function* filesOf({
  mesh,
  beside,
  recipe,
  workspace,
  assets,
}: ProjectFile): Generator<[string, Uint8Array<ArrayBuffer>]> {
  if (recipe !== undefined) yield [recipeName, encodeUtf8(recipe)];
  if (workspace !== undefined) yield [workspaceName, encodeUtf8(workspace)];
  yield* assets;
  yield [`${meshFolder}${mesh.name}`, mesh.bytes];
  for (const [path, bytes] of beside)
    yield [`${meshFolder}${isInside(path) ? path : nameOfPath(path)}`, bytes];
}

/** The folder in which the project lies, '' for none: people pack folders. Undefined if there is no project. */
function rootOf(entries: readonly ZipEntry[]): string | undefined {
  const names = entries.map(({ name }) => name);
  const roots = names
    .filter((name) => [recipeName, workspaceName].includes(nameOfPath(name)))
    .map((name) => name.slice(0, name.lastIndexOf('/') + 1));
  return roots.find((root) => names.some((name) => name.startsWith(`${root}${meshFolder}`)));
}

/** The mesh's path: the page says which file it is, else its name does. */
function meshIn(paths: readonly string[], workspace: string | undefined): string | undefined {
  const inFolder = paths.filter((path) => path.startsWith(meshFolder));
  try {
    const { mesh } = JSON.parse(workspace ?? '{}') as { mesh?: unknown };
    if (inFolder.includes(`${meshFolder}${mesh}`)) return `${meshFolder}${mesh}`;
  } catch {}
  return inFolder.find(isMeshFileName) ?? inFolder[0];
}

/** A copy where the bytes are a view of a larger whole, which they would keep alive. */
function own(bytes: Uint8Array): Uint8Array<ArrayBuffer> {
  const isWhole = bytes.byteLength === bytes.buffer.byteLength;
  return isWhole ? (bytes as Uint8Array<ArrayBuffer>) : bytes.slice();
}
