import { expect, test } from 'vitest';
import { formatRecipe, parseRecipe } from '../../src/recipe/index.ts';

test('a recipe is read step by step, absent parameters stay absent', () => {
  const handles = { vertices: [0, 17], targets: [[0, 0, 0], [0, 0, 1.5]] }; // biome-ignore format: pairs
  const text = JSON.stringify({
    whittle: 1,
    steps: [{ method: 'cubic', lambda: 0.4 }, { method: 'arap', handles }, { method: 'cubic' }],
  });
  expect(parseRecipe(text, 'r.json').steps).toEqual([
    { method: 'cubic', parameters: { lambda: 0.4 } },
    { method: 'arap', parameters: { handles } },
    { method: 'cubic', parameters: {} },
  ]);
  expect(parseRecipe(`\uFEFF${text}`, 'r.json').steps).toHaveLength(3);
});

test('what is formatted is read again', () => {
  const steps = [
    { method: 'cubic', parameters: { lambda: 0.1 + 0.2, maxIterations: 7 } },
    { method: 'cubic', parameters: { lambdaAxes: [1, 1, 0], orientation: [0, 0, 0.4, 0.9] } },
    { method: 'cubic', parameters: { polyhedron: [[1, 0, 0] as const, [0, 2, 0.5] as const] } },
    { method: 'cubic', parameters: { frames: [{ vertices: [3, 4], orientation: [0, 1, 0, 1] as const }] } },
    { method: 'arap', parameters: { handles: { vertices: [3], targets: [[1, -2.5, 1e-9] as const] } } },
  ];
  const text = formatRecipe({ steps });
  expect(parseRecipe(text, 'r.json')).toEqual({ steps });
  expect(text.split('\n')[3]).toBe('    {"method":"cubic","lambda":0.30000000000000004,"maxIterations":7},');
});

const broken: [string, number][] = [
  ['', 1],
  ['{\n "whittle": 1,\n "steps": [\n]', 4],
  ['{\n "whittle": 1\n "steps": []\n}', 3],
  ['{\n "whittle": 1,\n "steps": [1, ]\n}', 3],
  ['{\n "whittle": 01\n}', 2],
  ['{\n "a": "tab\there"\n}', 2],
  ["{\n\n'whittle': 1}", 3],
  ['{"a": {"b": [true, null, -1.5e+3, "\\u00e9\\n"]}}\nmore', 2],
];

test.each(broken)('%j is not JSON at line %i', (text, line) => {
  expect(() => parseRecipe(text, 'r.json')).toThrow(
    expect.objectContaining({
      ...{ code: 'bad-recipe', element: line, message: expect.stringMatching(`^r.json, line ${line}: `) },
    }),
  );
});

const step = (more: string) => `{"whittle": 1, "steps": [{"method": "cubic"}, ${more}]}`;
const refused: [string, string, RegExp][] = [
  ['[]', 'bad-recipe', /^r\.json: .*“whittle” is missing/],
  ['{"steps": [{"method": "cubic"}]}', 'bad-recipe', /“whittle” is missing/],
  ['{"whittle": 2, "steps": []}', 'bad-recipe', /version 2.*reads version 1/],
  ['{"whittle": 1}', 'bad-recipe', /“steps” must be a list/],
  ['{"whittle": 1, "steps": []}', 'bad-recipe', /one step or more/],
  ['{"whittle": 1, "step": []}', 'bad-recipe', /no entry “step”.*mean “steps”/],
  [step('"cubic"'), 'bad-recipe', /^r\.json, step 2: a step is an object/],
  [step('{"lambda": 1}'), 'bad-recipe', /step 2: “method” must name a method: cubic, analogy, polycube/],
  [step('{"method": "cubik"}'), 'unknown-method', /step 2: there is no method “cubik”.*mean “cubic”/],
  [step('{"method": "zzzzzz"}'), 'unknown-method', /There is: cubic, analogy, polycube/],
  [step('{"method": "cubic", "Lambda": 1}'), 'bad-parameter', /no parameter “Lambda”.*mean “lambda”/],
  [step('{"method": "cubic", "lambda": 101}'), 'bad-parameter', /“lambda” .*0 to 100, not 101/],
  [step('{"method": "cubic", "lambda": null}'), 'bad-parameter', /not null/],
  [
    step('{"method": "cubic", "lambdaAxes": [1, 1]}'),
    'bad-parameter',
    /“lambdaAxes” must be 3 numbers from 0 to 100/,
  ],
  [step('{"method": "cubic", "lambdaAxes": [1, 1, -1]}'), 'bad-parameter', /not \[1,1,-1\]/],
  [step('{"method": "cubic", "orientation": [0, 0, 0, 0]}'), 'bad-parameter', /not all of them zero/],
  [step('{"method": "cubic", "orientation": 45}'), 'bad-parameter', /must be a quaternion .* not 45/],
  [step('{"method": "cubic", "polyhedron": "sphere"}'), 'bad-parameter', /one of cube.*or a list of 12 rows/],
  [step('{"method": "cubic", "polyhedron": []}'), 'bad-parameter', /must list rows .*; it is empty/],
  [
    step('{"method": "cubic", "polyhedron": [[1, 0, 0], [0, 0, 0]]}'),
    'bad-parameter',
    /entry 1 is \[0,0,0\]/,
  ],
  [
    step(`{"method": "cubic", "polyhedron": ${JSON.stringify(Array(13).fill([1, 0, 0]))}}`),
    'bad-parameter',
    /12 rows at most; it has 13/,
  ],
  [step('{"method": "cubic", "frames": {}}'), 'bad-parameter', /“frames” must be \[\{"vertices"/],
  [step('{"method": "cubic", "frames": [null]}'), 'bad-parameter', /region 0 has no list of vertices/],
  [
    step('{"method": "cubic", "frames": [{"vertices": [0, 1.5], "orientation": [0, 0, 0, 1]}]}'),
    'bad-parameter',
    /entry 1 of region 0 is 1\.5/,
  ],
  [
    step('{"method": "cubic", "frames": [{"vertices": [], "orientation": [1]}]}'),
    'bad-parameter',
    /that of region 0 is \[1\]/,
  ],
  [
    step('{"method": "cubic", "frames": [{"vertices": [], "orientation": [0, 0, 0, 1], "name": "hand"}]}'),
    'bad-parameter',
    /region 0 has an entry “name” too many/,
  ],
  [step('{"method": "arap", "handles": [1]}'), 'bad-handles', /“handles” must be \{"vertices"/],
  [step('{"method": "arap", "handles": {"vertices": [1]}}'), 'bad-handles', /both lists/],
  [step('{"method": "arap", "planes": {}}'), 'bad-planes', /“planes” must be \[\{"vertices"/],
  [
    step('{"method": "arap", "planes": [{"normal": [1, 0, 0]}]}'),
    'bad-planes',
    /plane 0 has no list of vertices/,
  ],
  [step('{"method": "arap", "planes": [{"vertices": [-1]}]}'), 'bad-planes', /entry 0 of plane 0 is -1/],
  [
    step('{"method": "arap", "planes": [{"vertices": [1], "normal": [1, 0]}]}'),
    'bad-planes',
    /normal .*is \[1,0\]/,
  ],
  [
    step('{"method": "arap", "planes": [{"vertices": [1], "normal": [1, 0, 0]}]}'),
    'bad-planes',
    /as offset a finite/,
  ],
  [step('{"method": "arap", "planes": [{"vertices": [1], "normal": [1, 0, 0], "offset": 1, "at": 2}]}'), 'bad-planes', /“at” too many/], // biome-ignore format: short
  [
    step('{"method": "arap", "handles": {"vertices": [-1], "targets": [[0,0,0]]}}'),
    'bad-handles',
    /entry 0 is -1/,
  ],
  [
    step('{"method": "arap", "handles": {"vertices": [1], "targets": [[0,0]]}}'),
    'bad-handles',
    /entry 0 is \[0,0\]/,
  ],
  [
    step('{"method": "arap", "handles": {"vertices": [], "targets": [], "weights": []}}'),
    'bad-handles',
    /“weights”/,
  ],
];

test.each(refused)('%s is refused', (text, code, message) => {
  expect(() => parseRecipe(text, 'r.json')).toThrow(
    expect.objectContaining({ code, message: expect.stringMatching(message) }),
  );
});
