import { describe, expect, it } from 'vitest';
import { readMesh } from '../../src/io/index.ts';
import { ascii, cubePositions, cubeQuads, text } from '../fixtures/tiny-files.ts';
import { writtenBytes } from '../fixtures/written.ts';

/** Binary PLY files whose vertices cannot simply be overwritten. */

type Kind = 'Uint8' | 'Int8' | 'Uint16' | 'Int16' | 'Int32' | 'Float32';

const kindNames: Readonly<Record<Kind, string>> = {
  ...{ Uint8: 'uchar', Int8: 'char', Uint16: 'ushort', Int16: 'short', Int32: 'int', Float32: 'float' },
};

/** A cube with a list of 0, 1 or 2 numbers before each x, a label between y and z, and something behind the faces. */
function cube(kinds: readonly [Kind, Kind, Kind], little: boolean, size = 1): Uint8Array<ArrayBuffer> {
  const header = [
    ...['ply', `format binary_${little ? 'little' : 'big'}_endian 1.0`, 'element vertex 8'],
    ...[
      'property list uchar short near',
      `property ${kindNames[kinds[0]]} x`,
      `property ${kindNames[kinds[1]]} y`,
    ],
    ...[
      'property uchar label',
      `property ${kindNames[kinds[2]]} z`,
      'property float quality',
      'element face 6',
    ],
    ...['property list uchar int vertex_indices', 'element end 1', 'property int mark', 'end_header', ''],
  ].join('\n');
  const view = new DataView(new ArrayBuffer(4096));
  let at = 0;
  const put = (kind: Kind, value: number) => {
    view[`set${kind}`](at, value, little);
    at += Number(kind.replace(/\D+/, '')) / 8;
  };
  for (let v = 0; v < 8; v++) {
    put('Uint8', v % 3);
    for (let i = 0; i < v % 3; i++) put('Int16', 1000 + i);
    const position = cubePositions.slice(3 * v, 3 * v + 3).map((value) => size * value);
    put(kinds[0], position[0]!);
    put(kinds[1], position[1]!);
    put('Uint8', v);
    put(kinds[2], position[2]!);
    put('Float32', 0.5 * v);
  }
  for (const quad of cubeQuads) {
    put('Uint8', 4);
    for (const v of quad) put('Int32', v);
  }
  put('Int32', 12345);
  return Uint8Array.of(...ascii(header), ...new Uint8Array(view.buffer, 0, at));
}

const halves = (positions: Float64Array) => positions.map((value) => value / 2 + 0.25);

describe.each([true, false])('little endian: %s', (little) => {
  it('rows with lists are walked when they are written', () => {
    const bytes = cube(['Float32', 'Float32', 'Float32'], little);
    const { mesh, warnings } = readMesh(bytes, 'a.ply');
    expect(warnings).toEqual([]);
    expect([...mesh.positions]).toEqual(cubePositions);
    const written = writtenBytes(bytes, 'a.ply', 'ply-binary', halves(mesh.positions));
    expect(written).toHaveLength(bytes.length);
    expect(readMesh(written, 'a.ply').mesh).toMatchObject({
      positions: halves(mesh.positions),
      triangles: mesh.triangles,
    });
    expect(writtenBytes(written, 'a.ply', 'ply-binary', mesh.positions)).toEqual(bytes);
  });

  it.each([
    [['Int16', 'Int16', 'Int16'], 1],
    [['Uint8', 'Float32', 'Int8'], 100],
    [['Int32', 'Int32', 'Int32'], 1000],
  ] as const)('whole numbers become decimal ones: %j', (kinds, size) => {
    const bytes = cube([...kinds], little, size);
    const { mesh, warnings } = readMesh(bytes, 'a.ply');
    expect(warnings).toEqual([expect.stringMatching(/whole numbers; in the result they are decimal/)]);
    expect(writtenBytes(bytes, 'a.ply', 'ply-binary', mesh.positions)).toEqual(bytes);
    const moved = halves(mesh.positions);
    const written = writtenBytes(bytes, 'a.ply', 'ply-binary', moved);
    const again = readMesh(written, 'a.ply');
    expect(again.warnings).toEqual([]);
    expect(again.mesh).toMatchObject({ positions: moved, triangles: mesh.triangles });
    // The file that would have had decimal numbers from the beginning, but for its x, y and z.
    const float = cube(['Float32', 'Float32', 'Float32'], little, size);
    expect(writtenBytes(written, 'a.ply', 'ply-binary', mesh.positions)).toEqual(float);
  });

  it('large whole numbers become doubles, which hold them', () => {
    const bytes = cube(['Int32', 'Int32', 'Int32'], little, 2 ** 30);
    const moved = readMesh(bytes, 'a.ply').mesh.positions.map((value) => value + 0.125);
    const written = writtenBytes(bytes, 'a.ply', 'ply-binary', moved);
    expect(text(written.slice(0, 300))).toContain('property double z');
    expect(readMesh(written, 'a.ply').mesh.positions).toEqual(moved);
  });
});
