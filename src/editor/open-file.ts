import type { Engine } from '../engine/client.ts';
import type { ReadResult } from '../engine/protocol.ts';
import type { FilesBeside } from '../io/index.ts';
import type { Mesh, MeshReport } from '../mesh/mesh.ts';
import type { Source } from './project.ts';

/** A file that was read, with its bytes and its name. */
export interface ReadFile extends ReadResult {
  readonly bytes: Uint8Array<ArrayBuffer>;
  readonly name: string;
  readonly beside?: FilesBeside;
}

/** A file whose mesh can be worked on, before anything is done to it. */
export interface OpenedFile {
  readonly source: Source;
  readonly mesh: Mesh;
  readonly report: MeshReport;
  /** Sentences about what was ignored in it. */
  readonly warnings: readonly string[];
}

/** @throws WhittleError where the mesh is refused */
export async function openFile(
  engine: Engine,
  { bytes, name, beside, mesh, format, normalMap, warnings }: ReadFile,
  signal: AbortSignal,
): Promise<OpenedFile> {
  const report = await engine.inspect(mesh, { signal });
  const source = { bytes, name, format, ...(beside ? { beside } : {}), ...(normalMap ? { normalMap } : {}) };
  return { source, mesh, report, warnings };
}
