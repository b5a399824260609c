import type { Picture } from '../../web/app/image-gallery.ts';
import { offeredMethods, startingParameters, styleParameter } from '../../web/app/offered-methods.ts';
import type { Engine } from '../engine/client.ts';
import type { Mesh, MeshReport } from '../mesh/mesh.ts';
import type { MethodDescriptor } from '../methods/descriptor.ts';
import { findMethod } from '../methods/registry.ts';
import type { Shaping, Source, WhittleDocument } from './project.ts';

/** What a mesh opens with, where it is not the first method. */
export interface Beginning {
  readonly method?: MethodDescriptor;
  readonly picture?: Picture;
}

/** A file that was understood, before anything is done to its mesh. */
export interface OpenedFile {
  readonly source: Source;
  readonly mesh: Mesh;
  readonly report: MeshReport;
  /** Sentences about what was ignored in it. */
  readonly warnings: readonly string[];
}

/** @throws WhittleError where the file or its mesh is refused */
export async function understandFile(
  engine: Engine,
  bytes: Uint8Array<ArrayBuffer>,
  name: string,
  signal: AbortSignal,
): Promise<OpenedFile> {
  const { mesh, format, warnings, normalMap } = await engine.read(bytes, name, { signal });
  const report = await engine.inspect(mesh, { signal });
  return { source: { bytes, name, format, ...(normalMap ? { normalMap } : {}) }, mesh, report, warnings };
}

/**
 * The document that a file begins as, not carved yet.
 *
 * @param last what was done to the mesh before it, if there was one
 */
export function beginDocument(
  { source, mesh, report }: OpenedFile,
  begin: Beginning,
  last: Shaping | null,
): WhittleDocument {
  // A style is put on the next mesh too; other methods may not suit it.
  const before = findMethod(last?.method ?? '');
  const method = begin.method ?? (styleParameter(before) ? before! : offeredMethods()[0]!);
  const { style, directions } = last ?? { style: null, directions: null };
  // A normal map inside the file comes before what was chosen for another.
  const kept = source.normalMap || last?.picture?.file ? null : last?.picture;
  const picture = begin.picture ?? kept ?? null;
  const parameters = startingParameters(method, { report, style, mesh, picture });
  return { source, mesh, report, method: method.id, parameters, style, directions, picture, result: null };
}
