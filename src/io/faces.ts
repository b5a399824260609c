import { IndexList } from './lists.ts';
import type { Faces } from './parsed-file.ts';
import { counted, refusal } from './refuse.ts';

/** Collects polygons while a file is read and checks their indices once all vertices are known. */
export class FaceCollector {
  readonly #corners = new IndexList();
  readonly #start = new IndexList();
  readonly #places = new IndexList();
  #open = 0;
  #skipped = 0;
  #firstSkipped = 0;

  get faceCount(): number {
    return this.#start.length;
  }

  get cornerCount(): number {
    return this.#corners.length;
  }

  corner(vertex: number): void {
    this.#corners.push(vertex);
  }

  /**
   * Ends a polygon; one with fewer than three corners is dropped.
   *
   * @param place where the face stands: a byte offset, or its number in the file
   * @returns whether it was kept
   */
  end(place: number): boolean {
    const { length } = this.#corners;
    if (length - this.#open < 3) {
      if (this.#skipped++ === 0) this.#firstSkipped = place;
      this.#corners.length = this.#open;
      return false;
    }
    this.#start.push(this.#open);
    this.#places.push(place);
    this.#open = length;
    return true;
  }

  /**
   * @param describe makes "line 812" of a place
   * @param firstIndex how the file counts: from 0 or from 1
   * @throws no-faces, index-out-of-range
   */
  finish(name: string, vertices: number, describe: (place: number) => string, firstIndex: 0 | 1): Faces {
    const start = this.#start.take();
    const corners = this.#corners.take();
    if (start.length === 0) throw this.#noFaces(name, vertices);
    const closed = new Uint32Array(start.length + 1);
    closed.set(start);
    closed[start.length] = corners.length;
    for (let c = 0; c < corners.length; c++) {
      if (corners[c] < vertices) continue;
      let face = 0;
      while (closed[face + 1] <= c) face++;
      const place = describe(this.#places.take()[face]);
      const last = vertices - 1 + firstIndex;
      const range = vertices === 0 ? 'the file has none' : `the last one of the file is ${last}`;
      const sentence = `the face uses vertex ${corners[c] + firstIndex}, but ${range}; it was probably cut off. Export it again.`;
      throw refusal('index-out-of-range', name, place, sentence, face);
    }
    return { start: closed, corners };
  }

  /** What was dropped, as sentences. */
  warnings(describe: (place: number) => string): string[] {
    if (this.#skipped === 0) return [];
    const what = counted(this.#skipped, 'face');
    return [`Skipped ${what} with fewer than three corners (the first: ${describe(this.#firstSkipped)}).`];
  }

  #noFaces(name: string, vertices: number): Error {
    const what = vertices === 0 ? 'it holds no mesh' : `it holds ${counted(vertices, 'point')} but no faces`;
    return refusal('no-faces', name, '', `${what}; export it as a mesh with faces.`);
  }
}
