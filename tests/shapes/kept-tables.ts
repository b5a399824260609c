import { readFileSync, writeFileSync } from 'node:fs';

const file = 'docs/reshaping.md';

/** Puts tables into docs/reshaping.md, each between its two marks. @param tables by the names of the marks */
export function keepTables(tables: Readonly<Record<string, string>>): void {
  writeFileSync(file, replaced(readFileSync(file, 'utf8'), tables));
}

function replaced(text: string, tables: Readonly<Record<string, string>>): string {
  return Object.entries(tables).reduce((whole, [name, table]) => {
    const [begin, end] = [`<!-- ${name} -->`, `<!-- end of ${name} -->`];
    const [before, rest] = whole.split(begin);
    const after = rest?.split(end)[1];
    if (after === undefined) throw new Error(`${file} has no ${begin} … ${end}.`);
    return `${before}${begin}\n\n${table}\n\n${end}${after}`;
  }, text);
}
