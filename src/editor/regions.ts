import type { Mesh } from '../mesh/mesh.ts';
import { weldOf } from '../mesh/weld.ts';
import type { Quaternion } from '../methods/values/rotation.ts';
import type { Regions } from '../methods/values/rotations.ts';

/** Changes of the regions that are turned on their own, each a new list. */

/** One more region, last; its vertices leave those that they were in, and a region without vertices is none. */
export function withRegion(
  regions: Regions,
  mesh: Mesh,
  vertices: readonly number[],
  orientation: Quaternion,
): Regions {
  if (vertices.length === 0) return regions;
  const { vertexOfPosition } = weldOf(mesh);
  const taken = new Set(vertices.map((position) => vertexOfPosition[position]!));
  const others = regions
    .map((region) => ({
      ...region,
      vertices: region.vertices.filter((position) => !taken.has(vertexOfPosition[position]!)),
    }))
    .filter((region) => region.vertices.length > 0);
  return [...others, { vertices, orientation }];
}

export function withoutRegion(regions: Regions, index: number): Regions {
  return regions.filter((_, k) => k !== index);
}

export function turnedRegion(regions: Regions, index: number, orientation: Quaternion): Regions {
  return regions.map((region, k) => (k === index ? { ...region, orientation } : region));
}
