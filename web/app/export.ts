import { methods } from '../../src/methods/registry.ts';
import type { WhittleDocument } from '../document/document.ts';
import { styleOf } from '../document/offered-methods.ts';

export interface Format {
  readonly id: string;
  readonly extension: string;
  readonly label: string;
}

/** What the page can write, by the names of the file layer. */
export const formats: readonly Format[] = [
  { id: 'obj', extension: 'obj', label: 'OBJ' },
  { id: 'glb', extension: 'glb', label: 'glTF binary (GLB)' },
  { id: 'gltf', extension: 'gltf', label: 'glTF (text)' },
  { id: 'stl-binary', extension: 'stl', label: 'STL for printing' },
  { id: 'stl-ascii', extension: 'stl', label: 'STL (text)' },
  { id: 'ply-binary', extension: 'ply', label: 'PLY' },
  { id: 'ply-ascii', extension: 'ply', label: 'PLY (text)' },
  { id: 'off', extension: 'off', label: 'OFF' },
];

/** The format a document goes home in: the one it came in. */
export function ownFormat({ source }: WhittleDocument): Format {
  const known = formats.find(({ id }) => id === source.format);
  return known ?? { id: source.format, extension: extensionOf(source.name), label: source.format };
}

/** `rabbit.glb` shaped by `cubic` is `rabbit-cubic.glb`. */
export function exportName({ source, method }: WhittleDocument, format: Format): string {
  return `${stem(source.name)}-${method}.${format.extension}`;
}

/** The command line that makes the same file without the page. */
export function commandLine(document: WhittleDocument): string {
  const { source, method, parameters, picture } = document;
  const descriptor = methods.find(({ id }) => id === method);
  const flags = (descriptor?.parameters ?? []).flatMap((parameter) => {
    const flag = `--${kebab(parameter.name)}`;
    const style = parameter.kind === 'style' ? styleOf(document) : null;
    if (style) return [flag, quoted(style.source)];
    // A file's own normal map needs no mention.
    if (parameter.kind === 'relief') return picture && !picture.file ? [flag, quoted(picture.source)] : [];
    const value = parameters[parameter.name];
    if (!('default' in parameter) || value === undefined || value === parameter.default) return [];
    return [flag, String(value)];
  });
  const out = exportName(document, ownFormat(document));
  return ['npx whittle', method, quoted(source.name), ...flags, '--out', quoted(out)].join(' ');
}

function stem(name: string): string {
  return name.replace(/\.[^.]*$/, '') || 'mesh';
}

function extensionOf(name: string): string {
  return /\.([^.]+)$/.exec(name)?.[1]?.toLowerCase() ?? 'obj';
}

function kebab(name: string): string {
  return name.replace(/[A-Z]/g, (letter) => `-${letter.toLowerCase()}`);
}

/** As a POSIX shell reads it. */
function quoted(name: string): string {
  return /^[\w./-]+$/.test(name) ? name : `'${name.replaceAll("'", "'\\''")}'`;
}
