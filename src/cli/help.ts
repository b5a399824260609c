import type { MethodDescriptor } from '../methods/descriptor.ts';
import { kebabCase } from '../methods/kebab-case.ts';
import { methods } from '../methods/registry.ts';
import { type ParameterDescriptor, valueHelp } from '../methods/values/index.ts';

/** The text of `whittle --help`. */
export function generalHelp(): string {
  const list = methods.map(({ id, summary }) => `  ${id.padEnd(12)}${summary}`).join('\n');
  return `Stylize and reshape triangle meshes; only positions change, the rest of the file stays.

Usage
  whittle METHOD in.obj [--parameter value …] --out out.obj [--report report.json] [--quiet]
  whittle run recipe.json in.obj --out out.obj [--report report.json] [--quiet]
  whittle run project.whittle.zip --out out.obj     (mesh, recipe and all in one file, as the page saves it)
  whittle run - in.obj --out out.obj                (the recipe from stdin)
  whittle methods [--json]
  whittle METHOD --help

Methods
${list}

Flags
  --out FILE      where the result goes; its ending says the format. Written whole or not at all.
  --report FILE   counts of the mesh, and for each step iterations, outcome, energies and times, as JSON
  --quiet         no progress and no warnings
  --version       the version

Formats: OBJ, STL, PLY, OFF, 3MF, GLB and glTF. Ctrl-C stops after the current iteration and keeps what there is; a second
one stops at once.
Exit codes: 0 done, 1 bad input, 2 wrong usage, 3 failed numerically (nothing is written).
`;
}

/** A method with its parameters, defaults and ranges. */
export function methodHelp({ id, summary, paper, parameters }: MethodDescriptor): string {
  const head = `${id}: ${summary}\n  ${paper}\n`;
  return head + parameters.map((parameter) => parameterHelp(parameter)).join('');
}

/** The text of `whittle methods`. */
export function methodsHelp(): string {
  return methods.map(methodHelp).join('\n');
}

function parameterHelp(parameter: ParameterDescriptor): string {
  const { value, range } = valueHelp(parameter);
  return `  ${`--${kebabCase(parameter.name)} ${value}`.padEnd(33)}${range}\n      ${parameter.doc}\n`;
}
