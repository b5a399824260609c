import { type FilesBeside, findBeside, tidyPath } from '../beside.ts';
import { linearFromSrgb } from '../color.ts';
import type { Material, Texture } from '../look/look.ts';

/** Options that may stand before the name of a texture, with their values. */
const options = /^(-\w+(\s+([-+.\de]+|on|off|r|g|b|m|l|z))+\s+)+/;

/** The materials of an MTL file: diffuse colour, opacity and texture. Its colours are sRGB. */
export function readMtl(text: string, beside: FilesBeside): Material[] {
  const materials: MtlMaterial[] = [];
  for (const line of text.split(/\r\n|\n|\r/)) {
    const [, keyword = '', rest = ''] = /^\s*(\S+)\s*(.*?)\s*$/.exec(line) ?? [];
    if (keyword.toLowerCase() === 'newmtl') materials.push(new MtlMaterial(rest));
    else materials.at(-1)?.set(keyword, rest, beside);
  }
  return materials;
}

class MtlMaterial implements Material {
  readonly name: string;
  color: [number, number, number, number] = [1, 1, 1, 1];
  texture?: Texture;

  constructor(name: string) {
    this.name = name;
  }

  set(keyword: string, rest: string, beside: FilesBeside): void {
    const numbers = rest.split(/\s+/).map(Number).filter(Number.isFinite);
    if (keyword === 'Kd' && numbers.length >= 3) {
      const [red, green, blue] = numbers.map(linearFromSrgb);
      this.color = [red, green, blue, this.color[3]];
    } else if (keyword === 'd' && numbers.length > 0) this.color[3] = clamped(numbers.at(-1)!);
    else if (keyword === 'Tr' && numbers.length > 0) this.color[3] = clamped(1 - numbers[0]);
    else if (keyword.toLowerCase() === 'map_kd') {
      const name = tidyPath(rest.replace(options, ''));
      this.texture = { name, bytes: findBeside(beside, name) };
    }
  }
}

function clamped(value: number): number {
  return Math.min(1, Math.max(0, value));
}
