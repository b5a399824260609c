import { unzipSync } from 'fflate';
import { describe, expect, it } from 'vitest';
import { readMesh, writeMesh } from '../../src/io/index.ts';
import { readZip } from '../../src/io/zip.ts';
import { volumeInside } from '../fixtures/surfaces.ts';
import { cubeModel, cubePositions, pack3mf, text } from '../fixtures/tiny-files.ts';
import { writtenBytes } from '../fixtures/written.ts';

const main = '3D/3dmodel.model';
const cube = pack3mf({ [main]: cubeModel() });
const read = (model: string, others: Record<string, string> = {}) =>
  readMesh(pack3mf({ [main]: model, ...others }), 'a.3mf');
const item = '<item objectid="2" p:UUID="x"/>';

describe('what is given back', () => {
  it('changes numbers of vertices, and nothing else of the archive', () => {
    const { positions } = readMesh(cube, 'a.3mf').mesh;
    expect([...positions]).toEqual(cubePositions);
    const moved = positions.slice();
    moved[4] = 0.1 + 0.2;
    const written = writtenBytes(cube, 'a.3mf', '3mf', moved);
    const [before, after] = [unzipSync(cube), unzipSync(written)];
    expect(Object.keys(after)).toEqual(Object.keys(before));
    expect(text(after[main]!)).toBe(
      cubeModel().replace(`x='1.0' y="0"  z = "0"`, `x='1.0' y="0.30000000000000004"  z = "0"`),
    );
    // What is not touched is not even packed anew, and keeps its date and remark.
    const records = (zip: Uint8Array) =>
      readZip(zip, 'a').map(({ name, packed, record }) => ({
        name,
        packed,
        date: record.slice(12, 16),
        end: record.slice(46),
      }));
    const others = (zip: Uint8Array) => records(zip).filter(({ name }) => name !== main);
    expect(others(written)).toEqual(others(cube));
  });

  it('is in the frame of its objects, whatever their transforms', () => {
    const turned = cubeModel()
      .replace(item, '<item objectid="2" transform="0 2 0 -2 0 0 0 0 2 10 20 30"/>')
      .replace('transform="1 0 0 0 1 0 0 0 1 0 0 0"', 'transform="1 0 0 0 1 0 0 0 1 5 0 0"');
    const file = pack3mf({ [main]: turned });
    const { mesh } = readMesh(file, 'a.3mf');
    // (x, y, z) moves by 5 along x, turns to (−2y, 2x, 2z), and moves to the plate.
    expect([...mesh.positions.slice(0, 6)]).toEqual([10, 30, 30, 10, 32, 30]);
    const back = mesh.positions.map((value, i) => value + [0, 0.5, 4][i % 3]!);
    const written = writtenBytes(file, 'a.3mf', '3mf', back);
    expect(readMesh(written, 'a.3mf').mesh.positions).toEqual(back);
    expect(text(unzipSync(written)[main]!)).toContain(`<vertex x='0.25' y="0"  z = "2" />`);
  });

  it('holds against other programs’ way of packing: sizes behind the data', () => {
    const later = cube.slice();
    const view = new DataView(later.buffer);
    for (let at = 0; at + 4 < later.length; at++) {
      if (view.getUint32(at, true) === 0x04034b50)
        view.setUint16(at + 6, view.getUint16(at + 6, true) | 8, true);
      if (view.getUint32(at, true) === 0x02014b50)
        view.setUint16(at + 8, view.getUint16(at + 8, true) | 8, true);
    }
    const { positions } = readMesh(later, 'a.3mf').mesh;
    const moved = positions.map((value) => 2 * value);
    const written = writtenBytes(later, 'a.3mf', '3mf', moved);
    expect(readMesh(written, 'a.3mf').mesh.positions).toEqual(moved);
    expect(Object.keys(unzipSync(written))).toHaveLength(4);
  });
});

describe('what is read', () => {
  it('looks outwards where a transform mirrors', () => {
    const mirrored = cubeModel().replace(item, '<item objectid="2" transform="-1 0 0 0 1 0 0 0 1 0 0 0"/>');
    expect(volumeInside(read(mirrored).mesh)).toBeGreaterThan(0);
  });

  it('may be in other model files of the archive, as slicers of several parts have it', () => {
    const parts = cubeModel().replace(
      '<component objectid="1"',
      '<component p:path="/3D/Objects/part_1.model" objectid="4"',
    );
    const other = `<model><resources><object id="4"><mesh><vertices><vertex x="0" y="0" z="0"/><vertex x="1" y="0" z="0"/>
      <vertex x="0" y="1" z="0"/></vertices><triangles><triangle v1="0" v2="1" v3="2"/></triangles></mesh></object></resources><build/></model>`;
    const file = pack3mf({ [main]: parts, '3D/Objects/part_1.model': other });
    const { mesh } = readMesh(file, 'a.3mf');
    expect([...mesh.positions]).toEqual([0, 0, 0, 1, 0, 0, 0, 1, 0]);
    const written = writtenBytes(
      file,
      'a.3mf',
      '3mf',
      mesh.positions.map((value) => value * 3),
    );
    const after = unzipSync(written);
    expect(text(after['3D/Objects/part_1.model']!)).toBe(
      other.replace('x="1"', 'x="3"').replace('y="1"', 'y="3"'),
    );
    expect(text(after[main]!)).toBe(parts);
  });

  it('is taken once where it stands on the plate several times', () => {
    const twice = cubeModel().replace(
      item,
      `${item}<item objectid="2" transform="1 0 0 0 1 0 0 0 1 9 9 9"/>`,
    );
    const { mesh, warnings } = read(twice);
    expect([...mesh.positions]).toEqual(cubePositions);
    expect(warnings).toEqual([expect.stringMatching(/first place, and 1 copy will follow/)]);
  });

  it('has names and colours that other formats get or lack', () => {
    const { mesh } = readMesh(cube, 'a.3mf');
    const obj = writeMesh(cube, 'a.3mf', 'obj', mesh.positions);
    expect(text(obj.bytes)).toContain('\no a cube & more\n');
    expect(obj.warnings).toEqual(['The new OBJ file comes without colours and materials of its faces.']);
  });
});

describe('what is refused', () => {
  const model = cubeModel();
  it.each([
    ['a vertex without z', model.replace(/ z = "0"/, ''), /3dmodel\.model, byte \d+: a vertex has the z ""/],
    ['a vertex of words', model.replace('y="1"', 'y="one"'), /a vertex has the y "one"/],
    ['a triangle of two', model.replace(' v3="1"', ''), /no three vertices/],
    [
      'a triangle too far',
      model.replace('v3="1"', 'v3="8"'),
      /object 1: a triangle uses vertex 8, but there are only 8/,
    ],
    [
      'NaN that is used',
      model.replace('y="1"', 'y="nan"'),
      /object 1: vertex \d has a coordinate that is not finite/,
    ],
    ['a transform of eleven', model.replace('0 1 0 0 0"', '0 1 0 0"'), /has not twelve numbers/],
    ['an item of nothing', model.replace('objectid="2" p', 'objectid="3" p'), /there is no object "3"/],
    [
      'an object of itself',
      model.replace('<component objectid="1"', '<component objectid="2"'),
      /contains itself/,
    ],
    ['no triangles', model.replace(/<triangle .*\n/g, ''), /no triangles to print/],
    ['half a file', model.slice(0, 900), /ends too early; the file was cut off/],
  ])('%s', (_what, source, sentence) => {
    expect(() => read(source)).toThrow(expect.objectContaining({ message: expect.stringMatching(sentence) }));
  });

  it('an archive whose data is broken', () => {
    const broken = cube.slice();
    broken[400] ^= 255;
    expect(() => readMesh(broken, 'a.3mf')).toThrow(
      /^a\.3mf, "[^"]+": its data is broken; get the file again\.$/,
    );
  });
});
