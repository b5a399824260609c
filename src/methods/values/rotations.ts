import { WhittleError } from '../../mesh/failure.ts';
import { encodedNumbers, type Parameter, type ValueKind } from './parameter.ts';
import { verticesProblem } from './points.ts';
import { isQuaternion, type Quaternion, quaternionInWords } from './rotation.ts';
import { show } from './show.ts';

/** Vertices (indices of the source file's position list) and how they are turned; no vertex is in two of them. */
export type Regions = readonly { readonly vertices: readonly number[]; readonly orientation: Quaternion }[];

/** A rotation for parts of the mesh: {@link Regions}, of which the core gets one for each vertex. Absent or empty means none. */
export interface RotationsParameter extends Parameter {
  readonly kind: 'rotations';
}

export const rotations: ValueKind<RotationsParameter, Regions> = {
  problem(_, value) {
    const shape = 'must be [{"vertices": [index, …], "orientation": [x, y, z, w]}, …]';
    if (!Array.isArray(value)) return `${shape}, not ${show(value)}.`;
    for (const [index, region] of value.entries()) {
      const { vertices, orientation, ...rest } = (region ?? {}) as Partial<Record<string, unknown>>;
      if (!Array.isArray(vertices)) return `${shape}; region ${index} has no list of vertices.`;
      const [stranger] = Object.keys(rest);
      if (stranger !== undefined) return `${shape}; region ${index} has an entry “${stranger}” too many.`;
      const what = verticesProblem(vertices, ` of region ${index}`);
      if (what !== undefined) return what;
      if (!isQuaternion(orientation))
        return `must have as orientation ${quaternionInWords}; that of region ${index} is ${show(orientation)}.`;
    }
    return undefined;
  },
  /**
   * A quaternion for each welded vertex; zeros, which say nothing, for those of no region. A place that the file stores several
   * times belongs to the region that any of them is in.
   */
  encode({ name }, regions, { vertexOfPosition, positionOfVertex }) {
    const count = vertexOfPosition.length;
    if (regions.length === 0) return encodedNumbers([]);
    const quaternions = new Float64Array(4 * positionOfVertex.length);
    const owners = new Map<number, Member>();
    for (const [region, { vertices, orientation }] of regions.entries()) {
      for (const source of vertices) {
        const vertex = vertexOfPosition[source];
        if (vertex === undefined) {
          throw new WhittleError(
            'bad-parameter',
            `“${name}” names vertex ${source} in region ${region}, but the file has ${count} vertices (0 to ${count - 1}).`,
            source,
          );
        }
        const owner = owners.get(vertex);
        if (owner && owner.region !== region) throw overlap(name, owner, { region, source });
        owners.set(vertex, { region, source });
        quaternions.set(orientation, 4 * vertex);
      }
    }
    return encodedNumbers(quaternions);
  },
  help: () => ({
    value: 'FILE.json',
    range: '[{"vertices": [0, …], "orientation": [x, y, z, w]}, …], default none',
  }),
};

interface Member {
  readonly region: number;
  readonly source: number;
}

function overlap(name: string, first: Member, second: Member): WhittleError {
  const where = `regions ${first.region} and ${second.region} of “${name}”`;
  const message =
    first.source === second.source
      ? `Vertex ${second.source} is in ${where}; keep it in one.`
      : `Vertices ${first.source} and ${second.source} are in ${where}, but they are the same point of the surface ` +
        '(the file stores it twice, along a seam); keep it in one.';
  return new WhittleError('bad-parameter', message, second.source);
}
