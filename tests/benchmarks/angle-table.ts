import { writeFileSync } from 'node:fs';
import { eightPrimitives, evidenceLambda, restyle } from '../fixtures/style-angles.ts';
import { tenMeshes } from '../fixtures/ten-meshes.ts';
import { markdownTable } from './numbers.ts';

const tableFile = 'public/docs/style-angles.md';

/** How near ten meshes come to eight primitives, as the tests of the analogy measure it; `--write` keeps the table. */
export async function tabulateAngles(args: readonly string[]): Promise<void> {
  const rows: string[][] = [];
  for (const { name, about, mesh } of await tenMeshes()) {
    console.error(`${name} …`);
    const cells: string[] = [];
    for (const primitive of eightPrimitives) {
      const { before, after } = await restyle(mesh, primitive);
      cells.push(`${before.toFixed(1)} → ${after.toFixed(1)}`);
    }
    rows.push([`${name}: ${about}`, String(mesh.positions.length / 3), ...cells]);
  }
  const table = markdownTable(['mesh', 'vertices', ...eightPrimitives], rows);
  console.log(table);
  if (args.includes('--write')) writeFileSync(tableFile, `${introduction}\n\n${table}\n`);
}

const introduction = `# How near meshes come to a style

Mean angle between the faces of a mesh and the normals that the style has for them, in degrees, before → after \`analogy\` with
λ ${evidenceLambda} and defaults else; each face counts by its area. Targets are the closest normals of the primitive to those of the input
(2021, §3.1 and Fig. 15). \`npm run bench -- angles --write\` measures it anew; \`tests/contract/analogy-evidence.test.ts\` holds that every
angle falls by a fifth at least.`;
