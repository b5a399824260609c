import type { Image } from '../../src/inputs/images/image.ts';
import { isPng, readFinePng } from '../../src/inputs/images/png.ts';
import { WhittleError } from '../../src/mesh/failure.ts';

/** File names that mean a picture. */
export const pictureNames = /\.(png|jpe?g|webp)$/i;
export const pictureEndings = '.png,.jpg,.jpeg,.webp';

/**
 * Reads a picture: a PNG with all its bits, anything else as the browser does.
 *
 * @throws WhittleError `unsupported-file` for what the browser cannot read either, `malformed-file` for a broken PNG
 */
export async function readPicture(file: File): Promise<Image> {
  const bytes = new Uint8Array(await file.arrayBuffer());
  if (isPng(bytes)) return readFinePng(bytes, file.name);
  // As it is stored: a normal map's colours are no colours.
  const options = { colorSpaceConversion: 'none', premultiplyAlpha: 'none' } as const;
  const bitmap = await createImageBitmap(file, options).catch(() => {
    throw new WhittleError(
      'unsupported-file',
      `${file.name} could not be read as a picture; save it as PNG, JPEG or WebP.`,
    );
  });
  const { width, height } = bitmap;
  const pen = new OffscreenCanvas(width, height).getContext('2d')!;
  pen.drawImage(bitmap, 0, 0);
  bitmap.close();
  return { width, height, white: 255, data: pen.getImageData(0, 0, width, height).data };
}
