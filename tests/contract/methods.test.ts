import { expect, test } from 'vitest';
import { methods } from '../../src/methods/registry.ts';
import { testCore } from '../fixtures/core.ts';

test('descriptors and the core’s registry say the same: ids, names, kinds, defaults, ranges, staleness', async () => {
  const described = methods.map(({ id, parameters }) => ({
    id,
    parameters: parameters.map((parameter) => ({
      name: parameter.name,
      kind: parameter.kind,
      invalidates: parameter.invalidates,
      ...('min' in parameter ? { default: parameter.default, min: parameter.min, max: parameter.max } : {}),
    })),
  }));
  expect(described).toEqual((await testCore()).methods());
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
