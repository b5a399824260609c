import { defineConfig } from 'vitest/config';

/** What hangs is to end; what a busy machine makes slow is not to be taken for it. */
const patience = { testTimeout: 180_000, hookTimeout: 180_000 };

/** The tests that drive the built page in a real browser; the files are the same for each. */
const inBrowser = {
  ...patience,
  include: ['tests/browser/**/*.test.ts'],
  fileParallelism: false,
  isolate: false,
  globalSetup: 'tests/browser/support/shared.ts',
};

/** One project for everything that runs in Node, one for each browser. */
export default defineConfig({
  test: {
    projects: [
      {
        test: {
          name: 'node',
          include: ['tests/**/*.test.ts'],
          exclude: ['tests/browser/**', 'tests/figures/**'],
          ...patience,
        },
      },
      { test: { name: 'chromium', ...inBrowser, provide: { browser: 'chromium' } } },
      {
        test: {
          name: 'figures',
          ...inBrowser,
          include: ['tests/figures/**/*.test.ts'],
          provide: { browser: 'chromium' },
        },
      },
      { test: { name: 'firefox', ...inBrowser, provide: { browser: 'firefox' } } },
    ],
  },
});
