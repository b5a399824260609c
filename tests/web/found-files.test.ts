import { strToU8, zipSync } from 'fflate';
import { describe, expect, it } from 'vitest';
import { type FoundFile, filesOfDrop, readBeside, unpackArchives } from '../../web/app/found-files.ts';

const file = (path: string, content: string | Uint8Array<ArrayBuffer> = path): FoundFile => ({
  ...{ name: path.slice(path.lastIndexOf('/') + 1), path },
  arrayBuffer: async () =>
    (typeof content === 'string' ? strToU8(content) : content).slice().buffer as ArrayBuffer,
});
const text = (bytes: Uint8Array | undefined) => bytes && new TextDecoder().decode(bytes);

describe('archives', () => {
  const zip = zipSync({
    'house/house.obj': strToU8('mtllib house.mtl'),
    'house/maps/wood.png': strToU8('wood'),
    '__MACOSX/house/._house.obj': strToU8('no'),
    'house/.DS_Store': strToU8('no'),
  }) as Uint8Array<ArrayBuffer>;

  it('are replaced by what is in them, without what systems put there', async () => {
    const files = await unpackArchives([file('a.obj'), file('house.ZIP', zip)]);
    expect(files.map(({ name, path }) => [name, path])).toEqual([
      ['a.obj', 'a.obj'],
      ['house.obj', 'house/house.obj'],
      ['wood.png', 'house/maps/wood.png'],
    ]);
    expect(text(new Uint8Array(await files[2]!.arrayBuffer()))).toBe('wood');
    const plain = [file('a.obj')];
    expect(await unpackArchives(plain)).toBe(plain);
  });

  it('that are broken are refused by name', async () => {
    await expect(unpackArchives([file('a.zip', zip.slice(0, 40))])).rejects.toThrow(
      /^a\.zip could not be unpacked/,
    );
  });
});

describe('files beside a mesh', () => {
  const files = [
    ...['Pack/scene/Scene.gltf', 'Pack/scene/scene.bin', 'Pack/maps/Wood.png', 'Other/scene.bin'].map(
      (path) => file(path),
    ),
  ];
  const read = readBeside(files[0]!, files);

  it.each([
    ['scene.bin', 'Pack/scene/scene.bin'],
    ['../maps/wood.png', 'Pack/maps/Wood.png'],
    ['wood.png', 'Pack/maps/Wood.png'],
    ['gone.png', undefined],
    ['textures/wood.png', undefined],
  ])('%s is %s', async (path, found) => {
    expect(text(await read(path))).toBe(found);
  });
});

describe('a drop', () => {
  type Entry = Partial<FileSystemDirectoryEntry & FileSystemFileEntry>;
  const fileEntry = (fullPath: string): Entry => ({
    ...{ isDirectory: false, fullPath },
    file: (done) =>
      done({
        name: fullPath.slice(fullPath.lastIndexOf('/') + 1),
        arrayBuffer: async () => new ArrayBuffer(1),
      } as File),
  });
  const folder = (fullPath: string, ...batches: Entry[][]): Entry => ({
    ...{ isDirectory: true, fullPath },
    createReader: () => {
      const left = [...batches];
      return { readEntries: (done) => done((left.shift() ?? []) as FileSystemEntry[]) };
    },
  });
  const transfer = (...entries: Entry[]) =>
    ({
      items: entries.map((entry) => ({ webkitGetAsEntry: () => entry })),
      files: [{ name: 'plain.obj' }],
    }) as unknown as DataTransfer;

  it('of folders gives the files in them, however many at a time', async () => {
    const inner = folder('/house/maps', [fileEntry('/house/maps/wood.png')]);
    const outer = folder('/house', [fileEntry('/house/house.obj'), inner], [fileEntry('/house/.hidden')]);
    const files = await filesOfDrop(transfer(outer, fileEntry('/beside.obj')));
    expect(files.map(({ path }) => path).sort()).toEqual([
      'beside.obj',
      'house/house.obj',
      'house/maps/wood.png',
    ]);
  });

  it('of files alone is these', async () => {
    const files = await filesOfDrop(transfer(fileEntry('/plain.obj')));
    expect(files.map(({ path }) => path)).toEqual(['plain.obj']);
  });
});
