import { encode } from 'fast-png';
import { expect, test } from 'vitest';
import {
  pngOfSphereField,
  readSphereField,
  sphereFieldOfImage,
} from '../../src/inputs/fields/read-sphere-field.ts';
import { directionOfPixel, sampleSphere, sphereFieldOf } from '../../src/inputs/fields/sphere-field.ts';
import { decodePng } from '../../src/inputs/images/read.ts';
import type { Vec3 } from '../../src/mesh/vectors.ts';

/** Reads these bytes as if they were a file. */
const read = (bytes: Uint8Array<ArrayBuffer>) =>
  readSphereField('sky.png', { readFile: async () => bytes, decodeImage: decodePng });

const ramp = sphereFieldOf(16, ([x, y, z]) => 0.5 + 0.2 * x + 0.2 * y * z);

test('a field that is saved is read again, to half a step of 16 bits, and what was 8 bits to the bit', async () => {
  const again = await read(pngOfSphereField(ramp));
  expect([again.width, again.height]).toEqual([32, 16]);
  for (const [k, value] of again.values.entries())
    expect(Math.abs(value - ramp.values[k]!)).toBeLessThan(0.5001 / 65535);
  const bytes = Uint8Array.from({ length: 32 * 16 }, (_, k) => k % 256);
  const fromBytes = await read(new Uint8Array(encode({ width: 32, height: 16, data: bytes, channels: 1 })));
  expect([...fromBytes.values]).toEqual([...bytes].map((byte) => byte / 255));
  expect((await read(pngOfSphereField(fromBytes))).values).toEqual(fromBytes.values);
});

test('up is the top row, z the middle, x right of it', () => {
  const [width, height] = [8, 4];
  const spot = (column: number, row: number) => {
    const values = new Float64Array(width * height);
    values[row * width + column] = 1;
    return (direction: Vec3) => sampleSphere({ width, height, values }, direction);
  };
  for (let row = 0; row < height; row++)
    for (let column = 0; column < width; column++)
      expect(spot(column, row)(directionOfPixel(column, row, height))).toBeCloseTo(1, 12);
  expect(spot(4, 0)([0.01, 1, 0.02])).toBeGreaterThan(0.4);
  expect(spot(6, 2)([1, -0.3, -0.1])).toBeGreaterThan(0.5);
  expect(spot(4, 1)([0.1, 0.1, 1])).toBeGreaterThan(0.3);
  expect(spot(0, 1)([-0.01, 0.2, -1])).toBeGreaterThan(0.2);
  expect(spot(0, 1)([0.01, 0.2, -1])).toBeGreaterThan(0.2);
});

test('pictures that are no field are refused with a sentence that says why', async () => {
  const png = (width: number, height: number, channels: 1 | 3 = 1) =>
    new Uint8Array(encode({ width, height, data: new Uint8Array(width * height * channels), channels }));
  await expect(read(png(32, 32))).rejects.toThrow(
    /^sky\.png: a picture of the sphere must be twice as wide as high, .*not 32 × 32\.$/,
  );
  await expect(read(png(2, 1))).rejects.toThrow(/from 4 × 2/);
  expect((await read(png(4, 2, 3))).values).toEqual(new Float64Array(8));
  const data = new Uint8Array(4 * 2 * 3);
  data[3 * 6] = 200;
  const colored = new Uint8Array(encode({ width: 4, height: 2, data, channels: 3 }));
  await expect(read(colored)).rejects.toMatchObject({
    ...{
      code: 'unsupported-file',
      message: expect.stringMatching(/^sky\.png: .*colour at column 2, row 1, .*grey/),
    },
  });
  await expect(read(new TextEncoder().encode('no picture'))).rejects.toThrow(/^sky\.png is not a PNG/);
});

test('what is see-through is black', () => {
  const data = new Uint8Array(4 * 8).fill(255);
  data[3] = 0;
  const { values } = sphereFieldOfImage({ width: 4, height: 2, data, white: 255 }, 'a');
  expect([...values]).toEqual([0, 1, 1, 1, 1, 1, 1, 1]);
});
