import type { Shape } from '../parsed-file.ts';
import { counted } from '../refuse.ts';
import { imageType, type Look } from './look.ts';

/** What a format has room for beside positions and faces. */
export interface Room {
  readonly colors?: boolean;
  readonly uvs?: boolean;
  /** Names of parts. */
  readonly names?: boolean;
  /** Materials: their names alone, or colours and textures too. */
  readonly materials?: 'names' | 'whole';
}

/** Sentences about what a source has and a new file of another format lacks; none where it lacks nothing. */
export function losses({ colors, uvs, look }: Shape, room: Room, label: string): string[] {
  const lost: string[] = [];
  if (colors && !room.colors) lost.push('vertex colours');
  if (uvs && !room.uvs) lost.push('texture coordinates');
  if (look.parts.some(({ name }) => name !== '') && !room.names) lost.push('names of parts');
  lost.push(...lostMaterials(look, room), ...(look.besides ?? []));
  const sentences = lost.length > 0 ? [`The new ${label} file comes without ${listed(lost)}.`] : [];
  if (room.materials === 'whole') sentences.push(...lostLibraries(look), ...lostTextures(look));
  return sentences;
}

function lostMaterials({ materials }: Look, room: Room): string[] {
  if (materials.length === 0 || room.materials === 'whole') return [];
  const hasTextures = materials.some(({ texture }) => texture);
  const textures = hasTextures ? ['textures'] : [];
  if (!room.materials) return ['materials', ...textures];
  const hasColors = materials.some(({ color }) => color);
  return [...(hasColors ? ['colours of materials (it keeps their names)'] : []), ...textures];
}

function lostLibraries({ missing = [] }: Look): string[] {
  if (missing.length === 0) return [];
  return [`${listed(missing)} not found beside the file, so its materials come with their names alone.`];
}

/** Textures that were not found, or are of a kind that glTF does not hold. */
function lostTextures({ materials }: Look): string[] {
  const missing = new Set<string>();
  const foreign = new Set<string>();
  for (const { texture } of materials) {
    if (texture && !texture.bytes) missing.add(texture.name);
    else if (texture?.bytes && !imageType(texture.bytes)) foreign.add(texture.name);
  }
  const say = (names: Set<string>, why: string) =>
    names.size === 0 ? [] : [`${counted(names.size, 'texture')} ${why}: ${[...names].join(', ')}.`];
  return [
    ...say(missing, 'not found beside the file, so the new one comes without'),
    ...say(foreign, 'neither PNG nor JPEG, so the new file comes without'),
  ];
}

/** "a, b and c". */
function listed(words: readonly string[]): string {
  return words.length < 2 ? words.join('') : `${words.slice(0, -1).join(', ')} and ${words.at(-1)}`;
}
