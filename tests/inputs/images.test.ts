import { describe, expect, test } from 'vitest';
import { findPattern, patternIds } from '../../src/inputs/images/patterns.ts';
import { Pyramid } from '../../src/inputs/images/pyramid.ts';
import { shaded } from '../../src/inputs/images/shade.ts';
import { heightOfWhite, type Texture, textureOf } from '../../src/inputs/images/texture.ts';
import { legibility, textureSlopesOf, tilesAlong, tooFine } from '../../src/inputs/images/texture-slopes.ts';
import { normalMap, paint, plate } from '../fixtures/textured.ts';

const slopesAt = (texture: Texture, i: number, j: number) => [
  ...texture.slopes.subarray(2 * (j * texture.width + i), 2 * (j * texture.width + i) + 2),
];

describe('reading a picture', () => {
  const tilted = [0.5 - 0.3, 0.5, 0.9] as const; // normal (−0.6, 0, 0.8)

  test('normals are told from heights, and leaning to the left is rising to the right', () => {
    const texture = textureOf(
      paint(8, () => tilted),
      'a',
    );
    expect(slopesAt(texture, 3, 3)[0]).toBeCloseTo(0.75, 5);
    expect(slopesAt(texture, 3, 3)[1]).toBe(0);
    const grey = textureOf(
      paint(8, () => [0.5, 0.5, 0.5]),
      'b',
    );
    expect(grey.slopes.every((slope) => slope === 0)).toBe(true);
  });

  test('the top row of a picture is at v = 1: brighter upward is rising upward', () => {
    const ramp = paint(64, (_, v) => [v, v, v]);
    const texture = textureOf(ramp, 'a');
    expect(slopesAt(texture, 5, 30)[0]).toBe(0);
    expect(slopesAt(texture, 5, 30)[1]).toBeCloseTo(heightOfWhite, 5);
  });

  test('green points up, or down as in DirectX', () => {
    const leaning = paint(4, () => [0.5, 0.8, 0.9]);
    expect(slopesAt(textureOf(leaning, 'a'), 1, 1)[1]).toBeCloseTo(-0.75, 5);
    expect(slopesAt(textureOf(leaning, 'a', { green: 'down' }), 1, 1)[1]).toBeCloseTo(0.75, 5);
  });

  test('flat is flat, whether painted with 127 or 128; what is see-through too; what lies flat is steep with an end', () => {
    for (const byte of [127, 128]) {
      const flat = textureOf(
        paint(4, () => [byte / 255, byte / 255, 1]),
        'a',
      );
      expect(flat.slopes.every((slope) => Object.is(slope, 0))).toBe(true);
    }
    const holed = normalMap(8, (u) => u / 2);
    holed.data.set([0, 0, 0, 0], 4 * 9);
    const texture = textureOf(holed, 'a');
    expect(slopesAt(texture, 1, 1)).toEqual([0, 0]);
    expect(slopesAt(texture, 2, 1)[0]).toBeCloseTo(0.5, 2);
    const lying = textureOf(
      paint(4, () => [0, 0.5, 0.502]),
      'a',
      { reading: 'normals' },
    );
    expect(slopesAt(lying, 0, 0)[0]).toBeCloseTo(10, 5);
  });

  test('a normal map and the height map of the same shape say the same', () => {
    const waves = (u: number, v: number) => 0.02 * Math.sin(4 * Math.PI * u) * Math.cos(2 * Math.PI * v);
    const grey = paint(256, (u, v) => {
      const white = 0.5 + waves(u, v) / heightOfWhite;
      return [white, white, white];
    });
    const normals = textureOf(normalMap(256, waves), 'a').slopes;
    const heights = textureOf(grey, 'b').slopes;
    const far = normals.reduce((most, slope, i) => Math.max(most, Math.abs(slope - heights[i]!)), 0);
    expect(far).toBeLessThan(1e-3);
  });

  test('what is no normal map is not read as one, and no picture has no pixels', () => {
    expect(() =>
      textureOf(
        paint(4, () => [1, 0, 0]),
        'a.png',
        { reading: 'normals' },
      ),
    ).toThrow(/a.png: only 0 % of its pixels are normals/);
    expect(() => textureOf({ width: 0, height: 4, data: new Float32Array(), white: 1 }, 'b.png')).toThrow(
      /b.png: .*0 × 4/,
    );
  });
});

describe('a footprint', () => {
  const noisy: Texture = {
    width: 7,
    height: 5,
    slopes: new Float32Array(70).map((_, i) => Math.sin(12.9 * i * i)),
  };
  const mean = (k: number) => noisy.slopes.filter((_, i) => i % 2 === k).reduce((sum, x) => sum + x / 35, 0);

  test('as large as the picture is its mean, whatever its size', () => {
    const into = new Float64Array(2);
    new Pyramid(noisy).sample(0.3, 0.7, 20, into);
    expect(into[0]).toBeCloseTo(mean(0), 6);
    expect(into[1]).toBeCloseTo(mean(1), 6);
  });

  test('goes on beyond the edges of the picture', () => {
    const pyramid = new Pyramid(noisy);
    const [a, b] = [new Float64Array(2), new Float64Array(2)];
    for (const level of [0, 0.4, 1, 2.3]) {
      pyramid.sample(0.01, 0.99, level, a);
      pyramid.sample(-2.99, 3.99, level, b);
      expect(a[0]).toBeCloseTo(b[0]!, 6);
      expect(a[1]).toBeCloseTo(b[1]!, 6);
    }
  });
});

describe('on a mesh', () => {
  test('a coarse mesh sees the mean, a fine one every wave', () => {
    const stripes = textureOf(
      paint(256, (u) => [0.5 + 0.3 * Math.sign(Math.sin(128 * Math.PI * u)), 0.5, 0.9]),
      'stripes',
    );
    const largest = (n: number) =>
      textureSlopesOf(stripes, plate(n)).slopes.reduce((a, b) => Math.max(a, Math.abs(b)), 0);
    expect(largest(9)).toBeLessThan(0.05);
    expect(largest(256)).toBeGreaterThan(0.6);
    const coarse = legibility(stripes, plate(9));
    expect(coarse.pixelsPerEdge).toBeCloseTo(32, 0);
    expect(tooFine(coarse)).toMatch(/an edge spans about 32 of its pixels, and 0 % of the relief is left/);
    expect(tooFine(legibility(stripes, plate(256)))).toBeUndefined();
  });

  test('repeated, the picture is that much smaller', () => {
    const texture = textureOf(
      normalMap(64, (u, v) => 0.02 * Math.sin(2 * Math.PI * u) * v * (1 - v)),
      'a',
    );
    const mesh = plate(17);
    const twice = { uvs: mesh.uvs.map((x) => 2 * x) };
    expect(textureSlopesOf(texture, mesh, { repeat: 2 }).slopes).toEqual(
      textureSlopesOf(texture, twice).slopes,
    );
    expect(tilesAlong(mesh)).toBeCloseTo(Math.SQRT2, 6);
    expect(tilesAlong({ ...mesh, ...twice })).toBeCloseTo(2 * Math.SQRT2, 6);
  });

  test('corners without texture coordinates are flat; a mesh without any is refused', () => {
    const texture = textureOf(
      paint(4, () => [0.2, 0.5, 0.9]),
      'a',
    );
    const mesh = plate(3);
    mesh.uvs.fill(Number.NaN, 0, 6);
    const { slopes } = textureSlopesOf(texture, mesh);
    expect([...slopes.subarray(0, 6)]).toEqual([0, 0, 0, 0, 0, 0]);
    expect(slopes[6]).toBeCloseTo(0.75, 5);
    expect(() => textureSlopesOf(texture, {})).toThrow(/no texture coordinates, and normalmap needs them/);
  });
});

describe.each(patternIds)('the pattern %s', (id) => {
  test('meets itself at its edges, is steep enough to see and level as a whole', () => {
    const { width, height, slopes } = findPattern(id)!;
    const pyramid = new Pyramid(findPattern(id)!);
    expect(pyramid.steepness(0)).toBeGreaterThan(0.15);
    expect(pyramid.steepness(20)).toBeLessThan(1e-4);
    // No wall along the edges that is not within.
    const along = (i: number) => {
      let sum = 0;
      for (let j = 0; j < height; j++) sum += Math.abs(slopes[2 * (j * width + i)]!);
      return sum / height;
    };
    const inner = Array.from({ length: width - 2 }, (_, i) => along(i + 1));
    expect(along(0)).toBeLessThanOrEqual(1.05 * Math.max(...inner));
    expect(new Set(shaded(findPattern(id)!, 32)).size).toBeGreaterThan(20);
  });
});
