/** Files that lie beside a mesh file, by their paths from its folder: "scene.bin", "textures/wood.png". */
export type FilesBeside = ReadonlyMap<string, Uint8Array<ArrayBuffer>>;

export const nothingBeside: FilesBeside = new Map();

/** A file that a mesh file refers to. */
export interface Reference {
  /** As a path from the folder of the mesh file, with slashes. */
  readonly path: string;
  /** Whether the shape itself is in it; else it says how the shape looks. */
  readonly isShape: boolean;
}

/**
 * The file that a reference means. Exporters write paths of their own machine, and other capitals: what is not there by its path
 * is found by its name.
 */
export function findBeside(files: FilesBeside, path: string): Uint8Array<ArrayBuffer> | undefined {
  const exact = files.get(path);
  if (exact) return exact;
  const name = nameOfPath(path).toLowerCase();
  for (const [known, bytes] of files) if (nameOfPath(known).toLowerCase() === name) return bytes;
  return undefined;
}

/** The last part of a path. */
export function nameOfPath(path: string): string {
  return path.slice(path.lastIndexOf('/') + 1);
}

/** A path as a file has it, with slashes and without "./" before it. */
export function tidyPath(text: string): string {
  return text
    .trim()
    .replaceAll(/[\\/]+/g, '/')
    .replace(/^(\.\/)+/, '');
}
