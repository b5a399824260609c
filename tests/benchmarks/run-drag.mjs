// `npm run bench:drag` after set-up.
import { runThroughVite } from '../through-vite.mjs';

await runThroughVite('/tests/benchmarks/drag.ts', ({ benchmarkDrags }) => benchmarkDrags());
