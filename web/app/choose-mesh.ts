import { isMeshFileName } from '../../src/io/index.ts';

const companions = /\.(mtl|png|jpe?g|webp|tga|bmp|ktx2|bin|txt|md)$/i;

export interface Choice<Named> {
  readonly mesh: Named | null;
  /** What to tell the person, if anything. */
  readonly note: string | null;
}

/** Finds the mesh among dropped files. A single file is always tried: the bytes decide, not the name. */
export function chooseMesh<Named extends { readonly name: string }>(files: readonly Named[]): Choice<Named> {
  if (files.length <= 1) return { mesh: files[0] ?? null, note: null };
  const meshes = files.filter(({ name }) => isMeshFileName(name));
  const mesh = meshes[0] ?? files.find(({ name }) => !companions.test(name)) ?? null;
  if (!mesh) {
    return {
      mesh,
      note: 'None of these files is a mesh. Drop an OBJ, STL, PLY, OFF, 3MF, GLB or glTF file.',
    };
  }
  if (meshes.length > 1)
    return { mesh, note: `Opened ${mesh.name}; one mesh at a time, drop the others later.` };
  return { mesh, note: `Opened ${mesh.name}. Materials and textures stay as they are in your files.` };
}
