import type { Image } from '../../src/inputs/images/image.ts';
import { isPng, readFinePng } from '../../src/inputs/images/png.ts';
import { WhittleError } from '../../src/mesh/failure.ts';

/** File names that mean an image. */
export const imageNames = /\.(png|jpe?g|webp)$/i;
export const imageEndings = '.png,.jpg,.jpeg,.webp';

/**
 * Decodes an image: a PNG with all its bits, anything else as the browser does.
 *
 * @throws WhittleError `unsupported-file` for what the browser cannot read either, `malformed-file` for a broken PNG
 */
export async function readImage(bytes: Uint8Array<ArrayBuffer>, name: string): Promise<Image> {
  if (isPng(bytes)) return readFinePng(bytes, name);
  // As it is stored: a normal map's colours are no colours.
  const options = { colorSpaceConversion: 'none', premultiplyAlpha: 'none' } as const;
  const bitmap = await createImageBitmap(new Blob([bytes]), options).catch(() => {
    throw new WhittleError(
      'unsupported-file',
      `${name} could not be read as an image; save it as PNG, JPEG or WebP.`,
    );
  });
  const { width, height } = bitmap;
  const pen = new OffscreenCanvas(width, height).getContext('2d')!;
  pen.drawImage(bitmap, 0, 0);
  bitmap.close();
  return { width, height, white: 255, data: pen.getImageData(0, 0, width, height).data };
}
