import { fileURLToPath } from 'node:url';
import { defineConfig, type Plugin } from 'vite';
import { makeSamples } from './web/build/samples.mjs';

const here = (path: string) => fileURLToPath(new URL(path, import.meta.url));

/** The sample meshes are built, not stored: see to it that they are there before anything is served or copied. */
const samples: Plugin = { name: 'whittle-samples', buildStart: () => makeSamples() };

export default defineConfig({
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
});
