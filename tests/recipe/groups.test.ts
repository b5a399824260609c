import { describe, expect, test } from 'vitest';
import { checkGroups, formatRecipe, parseRecipe } from '../../src/recipe/index.ts';

const withGroups = (groups: unknown) => JSON.stringify({ whittle: 1, steps: [{ method: 'cubic' }], groups });
const ears = [
  { name: 'left ear', vertices: [0, 17] },
  { name: 'right “ear”', vertices: [] },
];

describe('named groups', () => {
  test('are read, and written one a line', () => {
    const recipe = parseRecipe(withGroups(ears), 'r.json');
    expect(recipe.groups).toEqual(ears);
    const text = formatRecipe(recipe);
    expect(text.split('\n').slice(4, 7)).toEqual([
      '  ],',
      '  "groups": [',
      '    {"name":"left ear","vertices":[0,17]},',
    ]);
    expect(parseRecipe(text, 'r.json')).toEqual(recipe);
  });

  test('leave no trace where there are none', () => {
    const recipe = parseRecipe(withGroups([]), 'r.json');
    expect(recipe).toEqual({ steps: [{ method: 'cubic', parameters: {} }] });
    expect(formatRecipe(recipe)).not.toContain('groups');
  });

  test.each([
    [{}, 'r.json: “groups” must be a list such as [{"name": "left ear", "vertices": [0, 17]}], not {}.'],
    [[7], 'r.json, group 1: a group is an object such as {"name": "left ear", "vertices": [0, 17]}.'],
    [
      [ears[0], { name: ' ', vertices: [] }],
      'r.json, group 2: “name” must be a text that is not empty, not " ".',
    ],
    [[{ vertices: [] }], 'r.json, group 1: “name” must be a text that is not empty, not undefined.'],
    [[{ name: 'a' }], 'r.json, group 1: “vertices” must be a list of vertices, not undefined.'],
    [
      [{ name: 'a', vertices: [0, -1] }],
      'r.json, group 1: “vertices” must name vertices by whole numbers from 0; entry 1 is -1.',
    ],
    [
      [{ name: 'a', vertexes: [] }],
      'r.json, group 1: a group has no entry “vertexes”. Did you mean “vertices”?',
    ],
    [[ears[0], ears[0]], 'r.json: two groups are called “left ear”; rename one.'],
  ])('%j are refused', (groups, message) => {
    expect(() => parseRecipe(withGroups(groups), 'r.json')).toThrow(
      expect.objectContaining({ code: 'bad-recipe', message }),
    );
  });

  test('are refused on a mesh that has not their vertices', () => {
    expect(() => checkGroups(ears, 18)).not.toThrow();
    expect(() => checkGroups(ears, 17)).toThrow(
      expect.objectContaining({
        code: 'bad-recipe',
        element: 17,
        message:
          'The group “left ear” names vertex 17, but the file has 17 vertices (0 to 16); is the recipe one for another file?',
      }),
    );
  });
});
