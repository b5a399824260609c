import { fileURLToPath } from 'node:url';
import { defineConfig, type Plugin, type UserConfig } from 'vite';
import { makeSamples } from './web/build/samples.mjs';

const here = (path: string) => fileURLToPath(new URL(path, import.meta.url));

/** The sample meshes are built, not stored: see to it that they are there before anything is served or copied. */
const samples: Plugin = { name: 'whittle-samples', buildStart: () => makeSamples() };

/** The page. */
const page: UserConfig = {
  root: here('./web'),
  base: './',
  publicDir: here('./public'),
  plugins: [samples],
  worker: { format: 'es' },
  build: {
    outDir: here('./dist/web'),
    emptyOutDir: true,
    target: 'es2022',
    assetsInlineLimit: 0,
    chunkSizeWarningLimit: 900,
  },
  server: { fs: { allow: [here('.')] } },
};

/** One script of the element, under the name by which pages and the other script know it; the wasm file lies beside them. */
function script(name: string, entry: string, emptyOutDir: boolean): UserConfig {
  return {
    ...page,
    root: here('.'),
    publicDir: false,
    plugins: [],
    build: {
      ...page.build,
      outDir: here('./dist/element'),
      emptyOutDir,
      rollupOptions: {
        input: here(entry),
        preserveEntrySignatures: 'strict',
        output: { entryFileNames: name, assetFileNames: '[name][extname]', codeSplitting: false },
      },
    },
  };
}

/** `vite build` makes the page, `--mode element` and then `--mode worker` the two scripts of `<whittle-view>`. */
export default defineConfig(({ mode }) => {
  if (mode === 'element') return script('whittle-view.js', './src/element/index.ts', true);
  if (mode === 'worker') return script('whittle-worker.js', './src/engine/worker.ts', false);
  return page;
});
