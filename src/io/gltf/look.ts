import type { Look, Material } from '../look/look.ts';
import type { GltfDocument, Json } from './document.ts';
import { elementOf, imageOf, imageOfTexture, recordOf } from './images.ts';
import type { GltfFile } from './scan.ts';

/** Names, materials and textures of the parts of a glTF scene. */
export function lookOfGltf(_bytes: Uint8Array, { document, primitives }: GltfFile): Look {
  const materials: Material[] = [];
  const indices = new Map<unknown, number>();
  const parts = primitives.map(({ firstFace, name, material }) => {
    if (material === undefined) return { firstFace, name };
    const index = indices.get(material) ?? materials.length;
    indices.set(material, index);
    if (index === materials.length) materials.push(materialOf(document, material));
    return { firstFace, name, material: index };
  });
  return { parts, materials, besides: besides(document) };
}

function materialOf(document: GltfDocument, index: unknown): Material {
  const { name, pbrMetallicRoughness } = elementOf(document, 'materials', index);
  const { baseColorFactor, baseColorTexture } = recordOf(pbrMetallicRoughness);
  const image = imageOfTexture(document, recordOf(baseColorTexture).index);
  const isColor = Array.isArray(baseColorFactor) && baseColorFactor.length === 4;
  return {
    name: typeof name === 'string' && name !== '' ? name : `material ${String(index)}`,
    ...(isColor ? { color: baseColorFactor as [number, number, number, number] } : {}),
    ...(image === undefined ? {} : { texture: imageOf(document, image) }),
  };
}

/** What only glTF has. */
function besides({ root }: GltfDocument): string[] {
  const has = (key: string) => Array.isArray(root[key]) && root[key].length > 0;
  const meshes = (Array.isArray(root.meshes) ? root.meshes : []) as Json[];
  const hasTargets = meshes.some((mesh) => {
    const primitives = recordOf(mesh).primitives;
    return Array.isArray(primitives) && primitives.some((primitive) => recordOf(primitive).targets);
  });
  return [
    ...(has('skins') ? ['its skeleton'] : []),
    ...(hasTargets ? ['morph targets'] : []),
    ...(has('animations') ? ['animations'] : []),
  ];
}
