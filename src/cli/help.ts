import type { ChoiceParameter, MethodDescriptor, ParameterDescriptor } from '../methods/descriptor.ts';
import { kebabCase } from '../methods/kebab-case.ts';
import { methods } from '../methods/registry.ts';

/** The text of `whittle --help`. */
export function generalHelp(): string {
  const list = methods.map(({ id, summary }) => `  ${id.padEnd(12)}${summary}`).join('\n');
  return `Stylize and reshape triangle meshes; only positions change, the rest of the file stays.

Usage
  whittle METHOD in.obj [--parameter value …] --out out.obj [--report report.json] [--quiet]
  whittle run recipe.json in.obj --out out.obj [--report report.json] [--quiet]
  whittle methods [--json]
  whittle METHOD --help

Methods
${list}

Flags
  --out FILE      where the result goes; its ending says the format. Written whole or not at all.
  --report FILE   counts of the mesh, and for each step iterations, outcome, energies and times, as JSON
  --quiet         no progress and no warnings
  --version       the version

Formats: OBJ, STL, PLY, OFF, GLB and glTF. Ctrl-C stops after the current iteration and keeps what there is; a second one
stops at once.
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

interface ValueHelp {
  readonly value: string;
  readonly range: string;
}

function choiceHelp({ choices, maxRows, default: usual }: ChoiceParameter): ValueHelp {
  const range = `${choices.join(' | ')}, default ${usual}`;
  if (!maxRows) return { value: 'NAME', range };
  return { value: 'NAME|FILE.json', range: `${range}; a FILE.json lists ${maxRows} rows [x, y, z] at most` };
}

function valueHelp(parameter: ParameterDescriptor): ValueHelp {
  switch (parameter.kind) {
    case 'number':
    case 'integer': {
      const { min, max, unit } = parameter;
      const range = `${min} to ${max}${unit && ` ${unit}`}, default ${parameter.default}`;
      return { value: parameter.kind === 'number' ? 'NUMBER' : 'COUNT', range };
    }
    case 'choice':
      return choiceHelp(parameter);
    case 'flag':
      return { value: '', range: `alone for true, or =true, =false; default ${parameter.default}` };
    case 'vector': {
      const { min, max, default: usual } = parameter;
      return { value: usual.map(() => 'N').join(), range: `${min} to ${max}, default ${usual.join()}` };
    }
    case 'rotation':
      return {
        value: 'X,Y,Z,W',
        range: `a quaternion of any length but 0, default ${parameter.default.join()}`,
      };
    case 'rotations':
      return {
        value: 'FILE.json',
        range: '[{"vertices": [0, …], "orientation": [x, y, z, w]}, …], default none',
      };
    case 'scalars':
      return {
        value: 'FILE.json',
        range: `[number, …] from ${parameter.min} to ${parameter.max}, default none`,
      };
    case 'style':
      return { value: 'NAME|FILE', range: `a FILE.json lists [[x, y, z], …]; default ${parameter.default}` };
    case 'relief':
      return { value: 'NAME|FILE.png', range: 'default the normal map inside the file, if there is one' };
    case 'handles':
      return { value: 'FILE.json', range: '{"vertices": [0, …], "targets": [[x, y, z], …]}, default none' };
  }
}
