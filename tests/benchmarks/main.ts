import { writeFileSync } from 'node:fs';
import { benchmarkAgainst } from './against.ts';
import { tabulateAngles } from './angle-table.ts';
import { isCompared, parseOptions } from './options.ts';
import { measure, measureReshaping } from './program.ts';
import { describeMachine, report } from './report.ts';
import { reportAlone } from './report-alone.ts';
import { reportReshaping } from './report-reshape.ts';

const resultsFile = 'docs/benchmarks.md';

/** The core against the plain Eigen path, natively and as wasm, or against another state of itself; or what styles reach. */
export async function benchmark(args: readonly string[]): Promise<void> {
  if (args[0] === 'angles') {
    await tabulateAngles(args.slice(1));
    return;
  }
  const options = parseOptions(args);
  if (options.against) {
    await benchmarkAgainst(options.against, options);
    return;
  }
  const sections: string[] = [];
  for (const method of options.methods) {
    const announce = <T>(size: T): T => {
      console.error(`${method}, ${size} ${method === 'reshape' ? 'faces' : 'vertices'} …`);
      return size;
    };
    if (isCompared(method)) {
      const measurements = options.sizes.map((size) => measure(method, announce(size)));
      if (sections.length === 0) sections.push(describeMachine(measurements[0]!));
      sections.push(report(method, measurements));
    } else if (method === 'reshape') {
      const reshapings = options.faceCounts.map((count) => measureReshaping(announce(count)));
      if (sections.length === 0) sections.push(describeMachine(reshapings[0]!));
      sections.push(reportReshaping(reshapings));
    } else {
      const timings = options.sizes.map((size) => measure(method, announce(size)));
      if (sections.length === 0) sections.push(describeMachine(timings[0]!));
      sections.push(reportAlone(method, timings));
    }
  }
  const text = `${sections.join('\n\n')}\n`;
  console.log(text);
  if (options.write) writeFileSync(resultsFile, `# Results of \`npm run bench\`\n\n${text}`);
}
