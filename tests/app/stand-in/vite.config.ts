import { fileURLToPath } from 'node:url';
import { defineConfig, mergeConfig } from 'vite';
import base from '../../../vite.config.ts';

/** The page with the real core and a stand-in for the file layer: `npx vite -c tests/app/stand-in/vite.config.ts`. */
export default mergeConfig(
  base,
  defineConfig({
    resolve: {
      alias: [
        {
          find: '../src/engine/in-browser.ts',
          replacement: fileURLToPath(new URL('./in-browser.ts', import.meta.url)),
        },
      ],
    },
  }),
);
