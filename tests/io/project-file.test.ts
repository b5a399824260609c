import { unzipSync } from 'fflate';
import { describe, expect, it } from 'vitest';
import { fitsInProject, isProjectFile, packProject, unpackProject } from '../../src/io/index.ts';
import { makeZip } from '../../src/io/zip.ts';

const bytes = (text: string) => new TextEncoder().encode(text) as Uint8Array<ArrayBuffer>;
const large = Uint8Array.from({ length: 3_000_001 }, (_, k) => (k * k) >> 7);
const project = {
  mesh: { name: 'Häschen.obj', bytes: large },
  beside: new Map([
    ['skin.mtl', bytes('newmtl a')],
    ['maps/wood.png', Uint8Array.of(1, 2, 3)],
  ]),
  recipe: '{"whittle": 1}',
  workspace: '{"mesh": "Häschen.obj"}',
  assets: new Map([['styles/oloid.obj', bytes('v 0 0 0')]]),
};

describe('a project file', () => {
  it('gives back what was put in, to the byte, and is the same each time', async () => {
    const packed = await packProject(project);
    expect(isProjectFile(packed)).toBe(true);
    const { mesh, ...rest } = unpackProject(packed, 'a.zip');
    const { mesh: _, ...others } = project;
    expect(rest).toEqual(others);
    expect(mesh.name).toBe('Häschen.obj');
    expect(large.every((byte, k) => byte === mesh.bytes[k])).toBe(true);
    const again = await packProject(project);
    expect(packed.every((byte, k) => byte === again[k])).toBe(true);
  });

  it('is a folder for others', async () => {
    const files = unzipSync(await packProject(project));
    expect(Object.keys(files)).toEqual([
      'recipe.json',
      'project.json',
      'styles/oloid.obj',
      'mesh/Häschen.obj',
      'mesh/skin.mtl',
      'mesh/maps/wood.png',
    ]);
    expect(files['mesh/Häschen.obj']).toHaveLength(large.length);
  });

  it('is known in a folder of its own, without what only pages know, and by its mesh', () => {
    const files = { 'recipe.json': '{}', 'mesh/a.txt': 'no', 'mesh/a.obj': 'yes', 'b.png': 'b' };
    const packed = makeZip(
      new Map(Object.entries(files).map(([name, text]) => [`My work/${name}`, bytes(text)])),
    );
    const found = unpackProject(packed, 'a.zip');
    expect(found.mesh).toEqual({ name: 'a.obj', bytes: bytes('yes') });
    expect([...found.assets.keys()]).toEqual(['b.png']);
    expect(found).not.toHaveProperty('workspace');
  });

  it('is not taken for another archive, and refused in a sentence where it is none', () => {
    const packed = makeZip(new Map([['house.obj', bytes('v 0 0 0')]]));
    expect(isProjectFile(packed)).toBe(false);
    expect(isProjectFile(bytes('v 0 0 0'))).toBe(false);
    expect(() => unpackProject(packed, 'a.zip')).toThrow(/^a\.zip: no project is in it/);
    expect(() => unpackProject(packed.slice(0, 30), 'a.zip')).toThrow(/^a\.zip/);
  });

  it.each([
    ['oloid.obj', true],
    ['styles/oloid.obj', true],
    ['..png', true],
    ['../oloid.obj', false],
    ['a/../../b.obj', false],
    ['/etc/b.obj', false],
    ['C:\\b.obj', false],
    ['C:/b.obj', false],
    ['recipe.json', false],
    ['project.json', false],
    ['mesh/a.obj', false],
  ])('has room for an asset %s: %s', (name, fits) => {
    expect(fitsInProject(name)).toBe(fits);
  });

  it('lays what lies beside the mesh elsewhere where its path leads out of the folder', async () => {
    const out = { ...project, beside: new Map([['../maps/wood.png', bytes('w')]]) };
    expect([...unpackProject(await packProject(out), 'a.zip').beside.keys()]).toEqual(['wood.png']);
  });
});
