/** An image, whatever file it came from. */
export interface Image {
  readonly width: number;
  readonly height: number;
  /** RGBA from 0 to `white`, rows from the top, 4·width·height numbers. */
  readonly data: Uint8Array | Uint8ClampedArray | Uint16Array | Float32Array;
  /** The largest of the numbers: 255, 65535 or 1. */
  readonly white: number;
}
