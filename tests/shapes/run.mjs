// `npm run reshape:table` after set-up.
import { runThroughVite } from '../through-vite.mjs';

await runThroughVite('/tests/shapes/table.ts', ({ tabulate }) => tabulate(process.argv.slice(2)));
