// `npm run reshape:found -- FOLDER` after set-up.
import { runThroughVite } from '../../through-vite.mjs';

await runThroughVite('/tests/shapes/found/found-table.ts', ({ tabulateFound }) =>
  tabulateFound(process.argv.slice(2)),
);
