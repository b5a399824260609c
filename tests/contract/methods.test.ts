import { expect, test } from 'vitest';
import { methods } from '../../src/methods/registry.ts';
import type { ParameterDescriptor } from '../../src/methods/values/index.ts';
import { configure, testCore } from '../fixtures/core.ts';
import { icosphere } from '../fixtures/meshes.ts';

const isForCore = (parameter: ParameterDescriptor) => !('isForLibrary' in parameter);

test('descriptors and the core’s registry say the same: ids, names, kinds, defaults, ranges, choices, staleness', async () => {
  const described = methods.map(({ id, parameters }) => ({
    id,
    parameters: parameters.filter(isForCore).map((parameter) => ({
      name: parameter.name,
      kind: parameter.kind,
      invalidates: parameter.invalidates,
      // A style's default is a name, which the core never sees.
      ...('default' in parameter && parameter.kind !== 'style' ? { default: parameter.default } : {}),
      ...('min' in parameter ? { min: parameter.min, max: parameter.max } : {}),
      ...('choices' in parameter ? { choices: parameter.choices } : {}),
      ...('maxRows' in parameter ? { maxRows: parameter.maxRows } : {}),
    })),
  }));
  expect(described).toEqual((await testCore()).methods());
});

test('the default of a choice is one of its names, and a stranger is refused', async () => {
  const session = (await testCore()).open();
  const ball = icosphere(1);
  session.load(ball.positions, ball.triangles);
  for (const { id, parameters } of methods) {
    for (const parameter of parameters) {
      if (parameter.kind !== 'choice' || !isForCore(parameter)) continue;
      expect(parameter.choices).toContain(parameter.default);
      for (const choice of parameter.choices) configure(session, ball, id, { [parameter.name]: choice });
      expect(() => configure(session, ball, id, { [parameter.name]: 'sideways' })).toThrowError(
        parameter.name,
      );
    }
  }
  session.free();
});

test('sliders lie within the hard range and hold the default', () => {
  for (const parameter of methods.flatMap((method) => method.parameters)) {
    if (!('slider' in parameter) || !parameter.slider) continue;
    expect(parameter.slider.min).toBeGreaterThanOrEqual(parameter.min);
    expect(parameter.slider.max).toBeLessThanOrEqual(parameter.max);
    expect(parameter.slider.min).toBeLessThanOrEqual(parameter.default);
    expect(parameter.slider.max).toBeGreaterThanOrEqual(parameter.default);
  }
});
