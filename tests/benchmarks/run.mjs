// `npm run bench` after set-up.
import { runThroughVite } from '../through-vite.mjs';

await runThroughVite('/tests/benchmarks/main.ts', ({ benchmark }) => benchmark(process.argv.slice(2)));
