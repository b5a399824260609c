/** How the parts of a mesh look and what they are called: what a new file of another format takes over, where it has room. */
export interface Look {
  /** In the order of the faces; every face belongs to one, if there are any. */
  readonly parts: readonly Part[];
  readonly materials: readonly Material[];
  /** Files that tell of its materials and are not there. */
  readonly missing?: readonly string[];
  /** What the file has that no other format holds, in a few words each: "animations". */
  readonly besides?: readonly string[];
}

/** Faces in a row with one name and one material. */
export interface Part {
  readonly firstFace: number;
  readonly name: string;
  /** Index among the materials. */
  readonly material?: number | undefined;
}

export interface Material {
  readonly name: string;
  /** Linear red, green, blue and opacity, 0 to 1. Default: white. */
  readonly color?: readonly [number, number, number, number] | undefined;
  /** The image of its colours. */
  readonly texture?: Texture | undefined;
}

export interface Texture {
  readonly name: string;
  /** Absent where the file is not there. */
  readonly bytes?: Uint8Array | undefined;
}

export const plainLook: Look = { parts: [], materials: [] };

/** The kind of an image by its first bytes; undefined for what glTF does not hold. */
export function imageType(bytes: Uint8Array): 'image/png' | 'image/jpeg' | undefined {
  if (bytes[0] === 0x89 && bytes[1] === 0x50 && bytes[2] === 0x4e) return 'image/png';
  return bytes[0] === 0xff && bytes[1] === 0xd8 ? 'image/jpeg' : undefined;
}
