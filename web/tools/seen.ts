import {
  atOnce,
  inSlices,
  type ScreenShape,
  type SelectableMesh,
  Visibility,
  type Work,
} from '../../src/selection/index.ts';
import type { Surface } from '../../src/viewer/surface.ts';
import type { Viewer } from '../../src/viewer/viewer.ts';
import type { ScreenMap } from './screen-map.ts';

/** A view that is turned is not looked from; one that has rested for so many milliseconds is. */
const rest = 60;

/** Where everything is on the canvas, and what of it is hidden. */
export interface SeenMesh {
  readonly shape: ScreenShape;
  readonly visibility: Visibility;
}

/** Remembers what is seen of a mesh from where one looks, and makes it beside other work before it is asked for. */
export class Seen {
  readonly #viewer: Viewer;
  /** Of the view that was looked from last. */
  #latest: { readonly map: ScreenMap; readonly mesh: SelectableMesh; seen: SeenMesh | null } | null = null;
  #preparing = new AbortController();
  #timer: ReturnType<typeof setTimeout> | undefined;

  constructor(viewer: Viewer) {
    this.#viewer = viewer;
    viewer.onShape(() => this.#forget());
  }

  of(map: ScreenMap, mesh: SelectableMesh): SeenMesh {
    const latest = this.#lookFrom(map, mesh);
    latest.seen ??= atOnce(this.#look(map, mesh));
    return latest.seen;
  }

  /** Looks already, as someone is about to ask. */
  prepare(map: ScreenMap, mesh: SelectableMesh): void {
    if (this.#latest && this.#latest.mesh === mesh && this.#latest.map.isLike(map)) return;
    const latest = this.#lookFrom(map, mesh);
    const { signal } = this.#preparing;
    const look = () =>
      inSlices(this.#look(map, mesh), { signal }).then(
        (seen) => {
          latest.seen ??= seen;
        },
        () => {},
      );
    this.#timer = setTimeout(look, rest);
  }

  #lookFrom(map: ScreenMap, mesh: SelectableMesh) {
    const latest = this.#latest;
    if (latest && latest.mesh === mesh && latest.map.isLike(map)) return latest;
    this.#forget();
    this.#latest = { map, mesh, seen: null };
    return this.#latest;
  }

  *#look(map: ScreenMap, { topology }: SelectableMesh): Work<SeenMesh> {
    const facing = facingOf(this.#viewer.space.surface!);
    yield;
    const shape = map.shape();
    yield;
    return { shape, visibility: yield* Visibility.of(topology, shape, facing) };
  }

  #forget(): void {
    clearTimeout(this.#timer);
    this.#preparing.abort();
    this.#preparing = new AbortController();
    this.#latest = null;
  }
}

const facings = new WeakMap<Surface, Surface['facing']>();

/** Which way the faces of a mesh look; measured once, as no step turns a mesh inside out. */
function facingOf(surface: Surface): Surface['facing'] {
  const facing = facings.get(surface) ?? surface.facing;
  facings.set(surface, facing);
  return facing;
}
