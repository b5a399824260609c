export interface Sample {
  readonly file: string;
  readonly title: string;
  readonly about: string;
  /** Has texture coordinates, and is fine enough to show a relief. */
  readonly isForImages?: boolean;
}

/** Meshes that come with the page; made by web/build/samples.mjs. The first is the one the page opens with. */
export const samples: readonly Sample[] = [
  { file: 'rabbit.glb', title: 'Rabbit', about: 'glTF, one part' },
  { file: 'suzanne.glb', title: 'Suzanne', about: 'glTF, three parts' },
  { file: 'vase.obj', title: 'Vase', about: 'OBJ of quads, open at the top' },
  { file: 'jar.glb', title: 'Jar', about: 'glTF with texture coordinates', isForImages: true },
  { file: 'knot.ply', title: 'Knot', about: 'PLY with vertex colours' },
];

/** Where a sample lies, from the page's folder: links lead there. */
export function sampleAddress({ file }: Sample): string {
  return `samples/${file}`;
}

export async function fetchSample(sample: Sample): Promise<Uint8Array<ArrayBuffer>> {
  const response = await fetch(`${import.meta.env.BASE_URL}${sampleAddress(sample)}`);
  if (!response.ok)
    throw new Error(`The sample ${sample.file} could not be fetched; open a file of your own.`);
  return new Uint8Array(await response.arrayBuffer());
}
