// `npm run same-bits` after set-up.
import { runThroughVite } from '../through-vite.mjs';

await runThroughVite('/tests/same-bits/main.ts', ({ sameBits }) => sameBits(process.argv.slice(2)));
