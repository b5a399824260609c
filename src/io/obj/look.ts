import { type FilesBeside, findBeside, type Reference, tidyPath } from '../beside.ts';
import { lineEndLength } from '../bytes.ts';
import type { Look, Material, Part } from '../look/look.ts';
import { readMtl } from './mtl.ts';
import type { ObjFile } from './scan.ts';

const decoder = new TextDecoder();
/** Words that begin lines which the look of a file needs. */
const naming = /^\s*(o|g|usemtl|mtllib)(?:\s+(.*))?$/;

/** What an OBJ file says of names and materials, the latter by the MTL files beside it. */
export function lookOfObj(bytes: Uint8Array, file: ObjFile, beside: FilesBeside): Look {
  const parts: Part[] = [];
  const materials: Material[] = [];
  const known = materialsBeside(bytes, beside);
  const indices = new Map<string, number>();
  let name = '';
  let material: number | undefined;
  for (const { face, keyword, text } of statements(bytes, file)) {
    if (keyword === 'mtllib') continue;
    if (keyword === 'usemtl') {
      material = indices.get(text) ?? materials.length;
      indices.set(text, material);
      if (material === materials.length) materials.push(known.get(text) ?? { name: text });
    } else name = text;
    if (parts.at(-1)?.firstFace === face) parts.pop();
    parts.push({ firstFace: face, name, material });
  }
  if (parts.length > 0 && parts[0].firstFace > 0) parts.unshift({ firstFace: 0, name: '' });
  // A group that ends where the faces end has none.
  return {
    parts: parts.filter(({ firstFace }) => firstFace < file.faces.start.length - 1),
    materials,
    missing: libraryPaths(bytes).filter(
      (path) => !namesOfLibrary(path, beside).some((known) => findBeside(beside, known)),
    ),
  };
}

/** The MTL files that an OBJ names, and the textures that are named by those of them which are there. */
export function referencesOfObj(bytes: Uint8Array, _name: string, beside: FilesBeside): Reference[] {
  const textures = [...materialsBeside(bytes, beside).values()].flatMap(({ texture }) =>
    texture ? [texture.name] : [],
  );
  const libraries = libraryPaths(bytes).flatMap((path) => namesOfLibrary(path, beside));
  return [...new Set([...libraries, ...textures])].map((path) => ({ path, isShape: false }));
}

interface Statement {
  /** How many faces stand before it. */
  readonly face: number;
  readonly keyword: 'o' | 'g' | 'usemtl' | 'mtllib';
  readonly text: string;
}

function* statements(bytes: Uint8Array, { statementOffsets, facesBefore }: ObjFile): Iterable<Statement> {
  for (let i = 0; i < statementOffsets.length; i++) {
    const [, keyword, text = ''] = naming.exec(lineAt(bytes, statementOffsets[i])) ?? [];
    if (keyword) yield { face: facesBefore[i], keyword: keyword as Statement['keyword'], text };
  }
}

/** What `mtllib` lines say. They are looked for without reading the file, which may be long. */
function libraryPaths(bytes: Uint8Array): string[] {
  const paths = new Set<string>();
  let isLineStart = true;
  for (let at = 0; at < bytes.length; at++) {
    if (isLineStart && bytes[at] === 109) {
      const [, keyword, text = ''] = naming.exec(lineAt(bytes, at)) ?? [];
      if (keyword === 'mtllib' && text !== '') paths.add(tidyPath(text));
    }
    isLineStart = bytes[at] <= 32 && (isLineStart || lineEndLength(bytes, at) > 0);
  }
  return [...paths];
}

/** One file, whose name may have blanks, or several without. */
function namesOfLibrary(path: string, beside: FilesBeside): string[] {
  return findBeside(beside, path) ? [path] : [...new Set([path, ...path.split(/\s+/)])];
}

function materialsBeside(bytes: Uint8Array, beside: FilesBeside): Map<string, Material> {
  const materials = new Map<string, Material>();
  for (const name of libraryPaths(bytes).flatMap((path) => namesOfLibrary(path, beside))) {
    const library = findBeside(beside, name);
    if (!library) continue;
    for (const material of readMtl(decoder.decode(library), beside)) materials.set(material.name, material);
  }
  return materials;
}

function lineAt(bytes: Uint8Array, begin: number): string {
  let end = begin;
  while (end < bytes.length && bytes[end] !== 10 && bytes[end] !== 13) end++;
  return decoder.decode(bytes.subarray(begin, end)).trimEnd();
}
