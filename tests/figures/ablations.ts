import { readFileSync } from 'node:fs';
import type { FigureMesh, Picture } from './figure.ts';
import type { Hand } from './hand.ts';

/** A shape as `tests/core/support/ablations.cpp` leaves it, without a term of the energy. */
export interface AblatedPicture extends Picture {
  /** Name of the file in the folder that WHITTLE_ABLATIONS names. */
  readonly file: string;
}

/** Its generator; the file is made by the tests. */
const made = (title: string): FigureMesh => ({
  title,
  path: 'tests/core/support/ablations.cpp',
  format: 'OBJ',
});

const similarity = {
  mesh: made('Column'),
  of: '2023, Fig. 6, above',
  paper: 'without similarity a cylinder is no longer one, though its sides look where they looked',
  differs: 'A column that two points half way up pull wider, seen from above.',
  look: (hand: Hand) => hand.sweeps([420, 600], [420, 790]),
};
const sphericity = {
  mesh: made('Pawn'),
  of: '2023, Fig. 6, below',
  paper: 'without sphericity what is round in the middle is not any more',
  differs: 'A ball between two rods that is pulled by its ends.',
};
const normals = {
  mesh: made('Column'),
  of: '2023, Fig. 14, left',
  paper: 'without normals the surface turns',
  differs: 'The column of Fig. 6.',
};
const size = {
  mesh: made('Bar'),
  of: '2023, Fig. 14, right',
  paper: 'where size counts as much as the rest, the result is like that of Poisson deformation',
  differs:
    'A bar that is pulled by the points in the middle of its ends. The print raises the weight of size by 1000, which changes next to nothing here; ours is ten times that of normals.',
};

const picture = (
  id: string,
  about: Omit<AblatedPicture, 'id' | 'caption' | 'file'>,
  file: string,
  caption: string,
): AblatedPicture => ({ id, ...about, file, caption });

/** With and without each term, by the core’s own alternation as printed: no parameter of the product switches one off. */
export const ablations: readonly AblatedPicture[] = [
  picture('column-whole', similarity, 'column, whole.obj', 'With all terms the column stays round.'),
  picture('column-dissimilar', similarity, 'column, similarity.obj', 'Without similarity it becomes oval.'),
  picture(
    'pawn-whole',
    sphericity,
    'pawn, whole.obj',
    'With all terms the ball stays as it is, the rods get longer.',
  ),
  picture(
    'pawn-oblong',
    sphericity,
    'pawn, sphericity.obj',
    'Without sphericity the ball becomes long and thick.',
  ),
  picture('column-upright', normals, 'column, whole.obj', 'With all terms the sides look where they looked.'),
  picture('column-dented', normals, 'column, normal.obj', 'Without normals the points leave dents.'),
  picture('bar-whole', size, 'bar, whole.obj', 'With all terms the ends stay flat.'),
  picture('bar-pulled', size, 'bar, size.obj', 'Where size counts more than normals, points are drawn out.'),
];

/** The file, standing: its z goes up. */
export function standing(path: string): Buffer {
  const text = readFileSync(path, 'utf8').replace(
    /^v (\S+) (\S+) (\S+)$/gm,
    (_, x, y, z) => `v ${x} ${z} ${-y}`,
  );
  return Buffer.from(text);
}
