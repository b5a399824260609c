import type { WhittleDocument } from '../../src/editor/project.ts';
import { type FormatInfo, formatInfo } from '../../src/io/index.ts';
import { kebabCase } from '../../src/methods/kebab-case.ts';
import { methods } from '../../src/methods/registry.ts';
import { styleOf } from './offered-methods.ts';

/** The format a document goes home in: the one it came in. */
export function ownFormat({ source }: WhittleDocument): FormatInfo {
  return formatInfo(source.format);
}

/** `rabbit.glb` shaped by `cubic` is `rabbit-cubic.glb`. @param ending with its dot */
export function exportName({ source, method }: WhittleDocument, ending: string): string {
  return `${stem(source.name)}-${method}${ending}`;
}

/** The command line that makes the same file without the page. */
export function commandLine(document: WhittleDocument): string {
  const { source, method, parameters, picture } = document;
  const descriptor = methods.find(({ id }) => id === method);
  const flags = (descriptor?.parameters ?? []).flatMap((parameter) => {
    const flag = `--${kebabCase(parameter.name)}`;
    const style = parameter.kind === 'style' ? styleOf(document) : null;
    if (style) return [flag, quoted(style.source)];
    // A file's own normal map needs no mention.
    if (parameter.kind === 'textureSlopes')
      return picture && !picture.file ? [flag, quoted(picture.source)] : [];
    const value = parameters[parameter.name];
    if (!('default' in parameter) || value === undefined || value === parameter.default) return [];
    return [flag, String(value)];
  });
  const out = exportName(document, ownFormat(document).ending);
  return ['npx whittle', method, quoted(source.name), ...flags, '--out', quoted(out)].join(' ');
}

function stem(name: string): string {
  return name.replace(/\.[^.]*$/, '') || 'mesh';
}

/** As a POSIX shell reads it. */
function quoted(name: string): string {
  return /^[\w./-]+$/.test(name) ? name : `'${name.replaceAll("'", "'\\''")}'`;
}
