import { describe, expect, it } from 'vitest';
import { isPng, readPng, writePng } from '../../src/inputs/images/png.ts';
import { captureIds, findCapture } from '../../src/inputs/styles/capture-gallery.ts';
import {
  blankMap,
  type CapturePixels,
  isSphereMap,
  mapOfPixels,
  onSphere,
  pixelsOfMap,
  sphereMap,
} from '../../src/inputs/styles/captures.ts';
import { lookup } from '../../src/inputs/styles/gauss-lookup.ts';
import { findPrimitive } from '../../src/inputs/styles/primitives.ts';
import { dot, length, row, unit, type Vec3 } from '../../src/mesh/vectors.ts';
import type { GaussMap } from '../../src/methods/values/gauss-map.ts';

const degrees = (a: Vec3, b: Vec3): number => (180 / Math.PI) * Math.acos(Math.min(1, dot(a, b)));

/** Angles between two maps at the captures' points, sorted. */
function errors(a: GaussMap, b: GaussMap): number[] {
  const { points } = onSphere(blankMap());
  const [inA, inB] = [lookup(a), lookup(b)];
  return Array.from({ length: points.length / 3 }, (_, v) => {
    const point = row(points, v);
    return degrees(inA(point), inB(point));
  }).sort((x, y) => x - y);
}
const quantile = (sorted: readonly number[], share: number): number =>
  sorted[Math.floor(share * (sorted.length - 1))]!;

describe('the picture of a ball', () => {
  it('has the point towards the viewer in its middle, right on the right and up above', () => {
    const { data } = pixelsOfMap(blankMap(), 101);
    const at = (i: number, j: number): number[] => [
      ...data.subarray(4 * (101 * j + i), 4 * (101 * j + i) + 4),
    ];
    expect(at(50, 50)).toEqual([128, 128, 255, 255]);
    expect(at(100, 50)[0]).toBeGreaterThan(245);
    expect(at(50, 0)[1]).toBeGreaterThan(245);
    expect(at(50, 100)[1]).toBeLessThan(10);
    expect(at(0, 0)[3]).toBe(0);
  });

  it.each([64, 256])('goes there and back at %i pixels', (size) => {
    const smooth = sphereMap(([x, y, z]) => unit([x + 0.3 * y, y, 0.5 * z]));
    const found = errors(smooth, mapOfPixels(pixelsOfMap(smooth, size)));
    expect(quantile(found, 0.5)).toBeLessThan(1.5);
    expect(quantile(found, 0.95)).toBeLessThan(4);
  });

  it('has its mirror image behind', () => {
    const oneSided = sphereMap(([x, y, z]) => unit([x + 0.4, y, z]));
    const read = lookup(mapOfPixels(pixelsOfMap(oneSided, 128)));
    const [front, back] = [read(unit([0.2, 0.3, 0.9])), read(unit([0.2, 0.3, -0.9]))];
    expect(degrees(front, [back[0], back[1], -back[2]])).toBeLessThan(0.5);
  });

  it('may have any background', () => {
    const pixels = pixelsOfMap(blankMap(), 64);
    const black = pixels.data.slice();
    for (let at = 0; at < black.length; at += 4) if (black[at + 3] === 0) black.set([0, 0, 0, 255], at);
    expect(mapOfPixels({ ...pixels, data: black })).toEqual(mapOfPixels(pixels));
  });

  it.each([
    [64, 15],
    [256, 8],
  ])('does not bleed into the rim from a ground of flat blue at %i pixels', (size, worst) => {
    const ball = pixelsOfMap(blankMap(), size);
    const data = ball.data.slice();
    for (let j = 0; j < size; j++)
      for (let i = 0; i < size; i++)
        if (Math.hypot(2 * i + 1 - size, 2 * j + 1 - size) > size)
          data.set([128, 128, 255, 255], 4 * (j * size + i));
    // A pixel inside the rim is so far from the rim as an angle.
    expect(errors(blankMap(), mapOfPixels({ ...ball, data })).at(-1)).toBeLessThan(worst);
  });
});

describe('the gallery', () => {
  it.each(captureIds)('%s holds unit normals and survives its own picture', (id) => {
    const { map } = findCapture(id)!;
    expect(isSphereMap(map)).toBe(true);
    for (let v = 0; 3 * v < map.normals.length; v++) expect(length(row(map.normals, v))).toBeCloseTo(1, 9);
    const found = errors(map, mapOfPixels(readPng(writePng(pixelsOfMap(map, 256)), 'a.png')));
    // Steps in the map move by a pixel, which is a lot of angle at few points.
    expect(quantile(found, 0.5)).toBeLessThan(1.5);
    expect(quantile(found, 0.8)).toBeLessThan(12);
  });

  it('has no other names', () => {
    expect(findCapture('photo')).toBeUndefined();
  });
});

it('looks up closest normals as they are defined', () => {
  const { normals } = findPrimitive('icosahedron')!;
  const map: GaussMap = { kind: 'closest', normals };
  const found = errors(map, onSphere(map));
  expect(quantile(found, 0.75)).toBeLessThan(0.01);
});

describe('PNG files', () => {
  it('come back as they were, with alpha', () => {
    const pixels = pixelsOfMap(blankMap(), 32);
    const bytes = writePng(pixels);
    expect(isPng(bytes)).toBe(true);
    expect([...readPng(bytes, 'a.png').data]).toEqual([...pixels.data]);
  });

  it.each([
    ['no PNG', Uint8Array.of(1, 2, 3), /a\.png.*Save it again/],
    ['half a PNG', writePng(pixelsOfMap(blankMap(), 32)).subarray(0, 200), /a\.png/],
  ])('are refused with a way out: %s', (_, bytes, sentence) => {
    expect(() => readPng(bytes, 'a.png')).toThrow(sentence);
  });
});

describe('what is no capture is refused in a sentence', () => {
  const filled = (width: number, height: number, color: readonly number[]): CapturePixels => ({
    width,
    height,
    data: Uint8Array.from({ length: 4 * width * height }, (_, at) => color[at % 4]!),
  });

  it.each([
    ['not square', filled(64, 48, [128, 128, 255, 255]), /64 × 48.*crop/],
    ['too small', filled(8, 8, [128, 128, 255, 255]), /8 pixels wide.*Scale/],
    ['a photo', filled(64, 64, [150, 120, 110, 255]), /Only 0 %.*normal/],
    ['see-through', filled(64, 64, [128, 128, 255, 0]), /Only 0 %/],
  ])('%s', (_, pixels, sentence) => {
    expect(() => mapOfPixels(pixels)).toThrow(sentence);
  });
});
