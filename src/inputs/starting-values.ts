import type { Mesh, MeshReport } from '../mesh/mesh.ts';
import type { MethodDescriptor } from '../methods/descriptor.ts';
import type { GaussMap } from '../methods/values/gauss-map.ts';
import type { ParameterDescriptor, ParameterValue, ParameterValues } from '../methods/values/index.ts';
import type { Texture } from './images/texture.ts';
import { legibility, tilesAlong } from './images/texture-slopes.ts';

/** What values to start from depend on. */
export interface StartingSurface {
  readonly mesh: Mesh;
  readonly report: MeshReport;
  /** The style that the method is to take; null where it takes none. */
  readonly style: GaussMap | null;
  /** The pattern of ours that is to be laid on the mesh; null for one's own image, which was made for the mesh. */
  readonly pattern: Texture | null;
}

/** What a method opens with on a mesh: its defaults, but for what depends on the mesh and on what it borrows. */
export function startingValues(
  method: MethodDescriptor,
  { mesh, report, style, pattern }: StartingSurface,
): ParameterValues {
  const values: Record<string, ParameterValue> = {};
  for (const parameter of method.parameters)
    if (isPlain(parameter)) values[parameter.name] = parameter.default;
  Object.assign(values, method.startingValues?.({ report, style }));
  if ('repeat' in values && pattern && mesh.uvs) values.repeat = startingRepeat(pattern, mesh);
  return values;
}

type PlainParameter = Extract<ParameterDescriptor, { kind: 'number' | 'integer' | 'flag' | 'choice' }>;

/** Numbers, flags and choices: what a control of its own can set. */
export function isPlain(parameter: ParameterDescriptor): parameter is PlainParameter {
  return ['number', 'integer', 'flag', 'choice'].includes(parameter.kind);
}

/** So many of a pattern's tiles along the mesh look right. */
const usualTiles = 3;
const mostRepeats = 8;
/** Fewer where the mesh could not show them: so much of the slopes must be left. */
const wellShown = 0.7;

/** How often a pattern comes at first: as its look asks for. */
function startingRepeat(pattern: Texture, mesh: Mesh): number {
  let repeat = Math.min(mostRepeats, Math.max(1, Math.round(usualTiles / tilesAlong(mesh))));
  while (repeat > 1 && legibility(pattern, mesh, { repeat }).kept < wellShown) repeat--;
  return repeat;
}
