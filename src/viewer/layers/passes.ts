import type { BufferGeometry } from 'three';
import type { Depth } from './layer.ts';

/** The passes in which something is drawn so that it is seen behind the surface as it should. */
export function passesOf(depth: Depth): readonly { opacity: number; isBehind: boolean }[] {
  const plain = { opacity: 1, isBehind: false };
  return depth === 'faint-behind' ? [{ opacity: 0.28, isBehind: true }, plain] : [plain];
}

/** Frees a geometry that may draw from the surface's own buffer of positions, which stays. */
export function letGo(geometry: BufferGeometry): void {
  geometry.deleteAttribute('position');
  geometry.dispose();
}
