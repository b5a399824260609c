import { expect, test } from 'vitest';
import { formatForFileName, formats as ioFormats } from '../../src/io/index.ts';
import { formats as pageFormats } from '../../web/app/export.ts';

test('the page offers just the formats of the file layer', () => {
  expect(pageFormats.map(({ id }) => id).toSorted()).toEqual([...ioFormats].toSorted());
});

test('a file saved from the page is written in the same format by its ending', () => {
  for (const { id, extension } of pageFormats) {
    const source = ioFormats.find((format) => format === id);
    expect(formatForFileName(`mesh.${extension}`, source)).toBe(id);
  }
});
