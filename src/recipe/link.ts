import { strFromU8, strToU8, unzlibSync, zlibSync } from 'fflate';
import { WhittleError } from '../mesh/failure.ts';
import { filesNamedBy } from './assets.ts';
import { formatRecipe, parseRecipe, type Recipe } from './recipe.ts';

/** A longer address does not come through mail and chat whole. */
const longest = 6000;
/** As long as one still reads it. */
const readable = 300;
/** No recipe of a link unfolds to more. */
const mostBytes = 2 ** 22;

/**
 * A recipe as the value of a fragment's parameter: short ones as JSON, which can be read and changed in the address, long ones
 * deflated, as base64url.
 *
 * @returns undefined if it would be too long for an address
 * @throws WhittleError `bad-recipe` if it names files, which an address cannot hold; the sentence names them
 */
export function linkText(recipe: Recipe): string | undefined {
  const files = filesNamedBy(recipe.steps).map(({ name }) => name);
  if (files.length > 0)
    throw new WhittleError(
      'bad-recipe',
      `A link cannot hold ${files.join(', ')}; send the project file instead.`,
    );
  const json = JSON.stringify(JSON.parse(formatRecipe(recipe)));
  const plain = encodeURIComponent(json).replaceAll('%2C', ',').replaceAll('%3A', ':');
  if (plain.length <= readable) return plain;
  const packed = base64Url(zlibSync(strToU8(json), { level: 9 }));
  return packed.length <= longest ? packed : undefined;
}

/** @throws WhittleError as `parseRecipe`, and `bad-recipe` for a link that was cut off on its way */
export function recipeOfLink(text: string): Recipe {
  const name = 'The link’s recipe';
  if (/^(\{|%7B)/i.test(text)) return parseRecipe(unescaped(text), name);
  try {
    const packed = Uint8Array.from(atob(text.replaceAll('-', '+').replaceAll('_', '/')), (c) =>
      c.charCodeAt(0),
    );
    return parseRecipe(strFromU8(unzlibSync(packed, { out: new Uint8Array(mostBytes) })), name);
  } catch (thrown) {
    if (thrown instanceof WhittleError) throw thrown;
    throw new WhittleError('bad-recipe', `${name} is not whole; copy the link again, to its end.`);
  }
}

function unescaped(text: string): string {
  try {
    return decodeURIComponent(text);
  } catch {
    return text;
  }
}

function base64Url(bytes: Uint8Array): string {
  const text = btoa(strFromU8(bytes, true));
  return text.replaceAll('+', '-').replaceAll('/', '_').replaceAll('=', '');
}
