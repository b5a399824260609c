/** Vertex colours: files (but glTF) hold sRGB, a `Mesh` holds linear light. */

export function linearFromSrgb(value: number): number {
  const v = Math.min(1, Math.max(0, value));
  return v <= 0.04045 ? v / 12.92 : ((v + 0.055) / 1.055) ** 2.4;
}

export function srgbFromLinear(value: number): number {
  const v = Math.min(1, Math.max(0, value));
  return v <= 0.0031308 ? v * 12.92 : 1.055 * v ** (1 / 2.4) - 0.055;
}

/** 0…255 in sRGB. */
export function byteFromLinear(value: number): number {
  return Math.round(255 * srgbFromLinear(value));
}

/**
 * Colours of a text file, #P×3 sRGB either in 0…1 or in 0…255, as linear light. What is not a number becomes white.
 */
export function linearColors(srgb: Float64Array): Float32Array<ArrayBuffer> {
  let largest = 0;
  for (const value of srgb) if (value > largest) largest = value;
  const scale = largest > 1 ? 255 : 1;
  const colors = new Float32Array(srgb.length);
  for (let i = 0; i < srgb.length; i++) {
    const value = srgb[i];
    colors[i] = Number.isFinite(value) ? linearFromSrgb(value / scale) : 1;
  }
  return colors;
}
