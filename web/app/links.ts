import type { Project } from '../../src/editor/project.ts';
import { recipeOf } from '../../src/editor/saved-recipe.ts';
import { linkText, type Recipe, recipeOfLink } from '../../src/recipe/index.ts';

/** What an address asks for: a mesh (`?src=`), a recipe (`#recipe=`), or both. */
export interface Link {
  /** Absolute, or from the page's own folder. */
  readonly src: string | null;
  /** Still to be read. */
  readonly recipe: string | null;
}

/** Null where the address asks for nothing. */
export function linkIn({ search, hash }: Pick<Location, 'search' | 'hash'>): Link | null {
  const src = new URLSearchParams(search).get('src');
  const recipe = /[#&]recipe=([^&]*)/.exec(hash)?.[1] ?? null;
  return src || recipe ? { src, recipe } : null;
}

/** @throws WhittleError with a sentence about the link */
export function recipeIn({ recipe }: Link): Recipe | undefined {
  return recipe === null ? undefined : recipeOfLink(recipe);
}

/**
 * The link to a project's shape.
 *
 * @param page the page's own address
 * @returns undefined if it would be too long
 * @throws Error with a sentence about what a link cannot hold
 */
export function linkTo(project: Project, page: string): string | undefined {
  const { address, name } = project.source;
  if (address === undefined)
    throw new Error(
      `A link cannot hold ${name}, which is on your computer only; send the project file instead.`,
    );
  // Groups are for the one who works on, and long.
  const { steps } = recipeOf(project);
  const text = steps.length > 0 ? linkText({ steps }) : '';
  if (text === undefined) return undefined;
  const src = encodeURIComponent(address).replaceAll('%2F', '/').replaceAll('%3A', ':');
  return `${page.replace(/[?#].*$/, '')}?src=${src}${text && `#recipe=${text}`}`;
}

/** A mesh of the web, by its address. */
export interface FetchedMesh {
  readonly name: string;
  readonly bytes: Uint8Array<ArrayBuffer>;
  /** Finds what lies beside it. */
  readonly readBeside: (path: string) => Promise<Uint8Array<ArrayBuffer> | undefined>;
}

/** @throws Error with a sentence: the address is none, nothing is there, or the server keeps it to its own pages */
export async function fetchMesh(src: string): Promise<FetchedMesh> {
  const url = new URL(src, document.baseURI);
  if (!/^https?:$/.test(url.protocol))
    throw new Error(`${src} is no web address; a link begins with https://.`);
  const name = decodeURIComponent(url.pathname.slice(url.pathname.lastIndexOf('/') + 1)) || 'mesh';
  const response = await fetch(url).catch(() => {
    throw new Error(
      `${name} could not be fetched: ${url.host} cannot be reached, or does not let other pages read its files (CORS). Download it and drop it here.`,
    );
  });
  if (!response.ok) throw new Error(`${name} is not at ${url.host} (${response.status}); check the link.`);
  const readBeside = async (path: string) => {
    const other = await fetch(new URL(path, url)).catch(() => undefined);
    return other?.ok ? bytesOf(other) : undefined;
  };
  return { name, bytes: await bytesOf(response), readBeside };
}

async function bytesOf(response: Response): Promise<Uint8Array<ArrayBuffer>> {
  return new Uint8Array(await response.arrayBuffer());
}
