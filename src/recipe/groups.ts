import { WhittleError } from '../mesh/failure.ts';
import { didYouMean } from '../methods/suggest.ts';
import { isObject } from '../methods/values/json.ts';
import { verticesProblem } from '../methods/values/points.ts';
import { show } from '../methods/values/show.ts';

/** Vertices that a person gave a name, to find them again. No step depends on them. */
export interface Group {
  /** No two groups of a recipe have the same. */
  readonly name: string;
  /** Of the source file's position list; the first position of each place is enough. */
  readonly vertices: readonly number[];
}

/**
 * Reads the entry `groups` of a recipe; absent means none.
 *
 * @param fileName what messages begin with
 * @throws WhittleError `bad-recipe`, its element the group's place in the list
 */
export function parseGroups(value: unknown, fileName: string): readonly Group[] {
  if (value === undefined) return [];
  if (!Array.isArray(value))
    throw bad(fileName, `“groups” must be a list such as [${example}], not ${show(value)}.`);
  const names = new Set<string>();
  return value.map((entry, index) => {
    const group = parseGroup(entry, `${fileName}, group ${index + 1}`, index);
    if (names.has(group.name))
      throw bad(fileName, `two groups are called “${group.name}”; rename one.`, index);
    names.add(group.name);
    return group;
  });
}

/**
 * Holds groups against the mesh that they are for.
 *
 * @param positions how many the mesh has
 * @throws WhittleError `bad-recipe`, its element the vertex
 */
export function checkGroups(groups: readonly Group[], positions: number): void {
  for (const { name, vertices } of groups) {
    const stranger = vertices.find((vertex) => vertex >= positions);
    if (stranger === undefined) continue;
    const has = `the file has ${positions} vertices (0 to ${positions - 1})`;
    const advice = 'is the recipe one for another file?';
    throw new WhittleError(
      'bad-recipe',
      `The group “${name}” names vertex ${stranger}, but ${has}; ${advice}`,
      stranger,
    );
  }
}

const example = '{"name": "left ear", "vertices": [0, 17]}';
const entries = ['name', 'vertices'];

function parseGroup(group: unknown, place: string, index: number): Group {
  if (!isObject(group)) throw bad(place, `a group is an object such as ${example}.`, index);
  const stranger = Object.keys(group).find((key) => !entries.includes(key));
  if (stranger !== undefined)
    throw bad(place, `a group has no entry “${stranger}”.${didYouMean(stranger, entries)}`, index);
  const { name, vertices } = group;
  if (typeof name !== 'string' || name.trim() === '')
    throw bad(place, `“name” must be a text that is not empty, not ${show(name)}.`, index);
  if (!Array.isArray(vertices))
    throw bad(place, `“vertices” must be a list of vertices, not ${show(vertices)}.`, index);
  const problem = verticesProblem(vertices);
  if (problem !== undefined) throw bad(place, `“vertices” ${problem}`, index);
  return { name, vertices: vertices as number[] };
}

function bad(place: string, what: string, element?: number): WhittleError {
  return new WhittleError('bad-recipe', `${place}: ${what}`, element);
}
