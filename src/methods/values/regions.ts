import { WhittleError } from '../../mesh/failure.ts';
import type { Weld } from '../../mesh/weld.ts';
import type { Regions } from '../descriptor.ts';

/**
 * A quaternion for each welded vertex, x y z w; zeros, which say nothing, for those of no region. A place that the file stores
 * several times belongs to the region that any of them is in.
 *
 * @returns #V×4, or nothing where there are no regions
 * @throws WhittleError `bad-parameter`, its element the source vertex: no such vertex, or one in two regions
 */
export function weldRegions(
  name: string,
  regions: Regions,
  { vertexOfPosition, positionOfVertex }: Weld,
): Float64Array {
  const count = vertexOfPosition.length;
  if (regions.length === 0) return new Float64Array();
  const quaternions = new Float64Array(4 * positionOfVertex.length);
  const owners = new Map<number, { region: number; source: number }>();
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
  return quaternions;
}

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
