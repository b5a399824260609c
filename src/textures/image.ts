/** A picture, whatever file it came from. */
export interface Image {
  readonly width: number;
  readonly height: number;
  /** RGBA from 0 to 1, rows from the top, 4·width·height numbers. */
  readonly data: Float32Array;
}

/** A picture of bytes, as a canvas gives them. */
export function imageOfBytes(width: number, height: number, bytes: ArrayLike<number>): Image {
  return { width, height, data: Float32Array.from(bytes, (byte) => byte / 255) };
}
