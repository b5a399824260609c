import type { Mesh } from '../../src/mesh/mesh.ts';
import { gather, weldOf } from '../../src/mesh/weld.ts';
import { inSlices, type MirrorMap, type MirrorPlane, mirrorMap } from '../../src/selection/index.ts';

const known = new WeakMap<Mesh, Map<number, Promise<MirrorMap>>>();

/** Which vertices lie opposite each other on the file's own shape; found beside other work, once a mesh and axis. */
export function mirrorOf(mesh: Mesh, axis: MirrorPlane['axis']): Promise<MirrorMap> {
  const ofMesh = known.get(mesh) ?? new Map<number, Promise<MirrorMap>>();
  known.set(mesh, ofMesh);
  const map = ofMesh.get(axis) ?? inSlices(mirrorMap(gather(mesh.positions, weldOf(mesh)), axis));
  ofMesh.set(axis, map);
  return map;
}

/** The mirror across x of the mesh that tools work on, for those who need it at once: null until it is found. */
export class Mirror {
  #found: { readonly mesh: Mesh; readonly map: MirrorMap } | null = null;
  #sought: Mesh | null = null;

  /** @returns the mesh's mirror; if it is not known yet it is sought, and `found` is called */
  of(mesh: Mesh, found: () => void): MirrorMap | null {
    if (this.#found?.mesh === mesh) return this.#found.map;
    if (this.#sought === mesh) return null;
    this.#sought = mesh;
    void mirrorOf(mesh, 0).then((map) => {
      if (this.#sought !== mesh) return;
      this.#found = { mesh, map };
      found();
    });
    return null;
  }
}
