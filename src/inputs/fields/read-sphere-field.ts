import { at, WhittleError } from '../../mesh/failure.ts';
import { type SphereField, sphereSizeProblem } from '../../methods/values/sphere-field.ts';
import type { Image } from '../images/image.ts';
import { writeGreyPng } from '../images/png.ts';
import type { ImageReading } from '../images/read.ts';

/**
 * Reads a field from a grey PNG of the sphere: white is 1, black is 0, in between as the numbers stand in the file.
 *
 * @throws WhittleError with a sentence that begins with the file, as {@link sphereFieldOfImage} and the readers
 */
export async function readSphereField(
  name: string,
  { readFile, decodeImage }: ImageReading,
): Promise<SphereField> {
  const bytes = await readFile(name);
  return sphereFieldOfImage(await at(name, decodeImage(bytes, name)), name);
}

/** Colours whose parts differ by less are grey, give or take what an editor rounds. */
const greyTolerance = 2 / 255;

/**
 * What a picture of the sphere says. What is see-through is black.
 *
 * @throws WhittleError `unsupported-file` for a picture that is not twice as wide as high, too small or large, or in colour
 */
export function sphereFieldOfImage({ width, height, data, white }: Image, name: string): SphereField {
  const size = sphereSizeProblem(width, height);
  if (size !== undefined) throw unsuitable(name, `a picture of the sphere ${size}`);
  const values = new Float64Array(width * height);
  for (let pixel = 0; pixel < values.length; pixel++) {
    const [red, green, blue, alpha] = data.subarray(4 * pixel, 4 * pixel + 4) as unknown as [
      number,
      number,
      number,
      number,
    ];
    if (Math.max(red, green, blue) - Math.min(red, green, blue) > greyTolerance * white) {
      const place = `column ${pixel % width}, row ${Math.floor(pixel / width)}`;
      throw unsuitable(
        name,
        `it is in colour at ${place}, but strength is read from grey; save it as a grey picture.`,
      );
    }
    values[pixel] = (green / white) * (alpha / white);
  }
  return { width, height, values };
}

function unsuitable(name: string, what: string): WhittleError {
  return new WhittleError('unsupported-file', `${name}: ${what}`);
}

/** The brightest of a PNG of 16 bits. */
const white = 65535;

/** The field in the steps of the PNG that it is saved as, which then says the same to the bit. */
export function inSavedSteps(field: SphereField): SphereField {
  return { ...field, values: Float64Array.from(field.values, (value) => Math.round(white * value) / white) };
}

/** The field as a grey PNG of 16 bits, to be read again by {@link readSphereField}. */
export function pngOfSphereField({ width, height, values }: SphereField): Uint8Array<ArrayBuffer> {
  return writeGreyPng({
    width,
    height,
    data: Uint16Array.from(values, (value) => Math.round(white * value)),
  });
}
