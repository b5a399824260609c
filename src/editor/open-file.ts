import type { Engine } from '../engine/client.ts';
import type { Mesh, MeshReport } from '../mesh/mesh.ts';
import type { Source } from './project.ts';

/** A file that was understood, before anything is done to its mesh. */
export interface OpenedFile {
  readonly source: Source;
  readonly mesh: Mesh;
  readonly report: MeshReport;
  /** Sentences about what was ignored in it. */
  readonly warnings: readonly string[];
}

/** @throws WhittleError where the file or its mesh is refused */
export async function openFile(
  engine: Engine,
  bytes: Uint8Array<ArrayBuffer>,
  name: string,
  signal: AbortSignal,
): Promise<OpenedFile> {
  const { mesh, format, warnings, normalMap } = await engine.read(bytes, name, { signal });
  const report = await engine.inspect(mesh, { signal });
  return { source: { bytes, name, format, ...(normalMap ? { normalMap } : {}) }, mesh, report, warnings };
}
