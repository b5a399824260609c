import { html, svg } from 'lit';
import { zonotopeFaces } from '../../src/inputs/styles/zonotope.ts';
import { dot, unit, type Vec3 } from '../../src/mesh/vectors.ts';

/** From where pictures are seen: a little from the right and from above. */
const right: Vec3 = unit([0.89, 0, -0.46]);
const toEye: Vec3 = unit([0.43, 0.36, 0.83]);
const up: Vec3 = unit([
  toEye[1] * right[2] - toEye[2] * right[1],
  toEye[2] * right[0] - toEye[0] * right[2],
  toEye[0] * right[1] - toEye[1] * right[0],
]);

/** A small drawing of the polyhedron of some rows; a dash where they make none. */
export function zonotopePicture(rows: readonly Vec3[], size = 44) {
  const seen = zonotopeFaces(rows).filter(({ normal }) => dot(normal, toEye) > 1e-6);
  if (seen.length === 0) return html`<span class="no-picture" aria-hidden="true">–</span>`;
  const places = seen.map(({ corners }) =>
    corners.map((corner) => [dot(corner, right), -dot(corner, up)] as const),
  );
  const reach = 1.06 * Math.max(...places.flat(2).map(Math.abs));
  return html`
    <svg class="zonotope" width=${size} height=${size} viewBox="${-reach} ${-reach} ${2 * reach} ${2 * reach}" aria-hidden="true">
      ${seen.map(
        ({ normal }, k) =>
          svg`<path style="--light:${Math.round(100 * Math.max(0, 0.2 + 0.8 * dot(normal, light)))}%" stroke-width=${reach / 40} d="M${places[k]!.map((place) => place.map((value) => value.toFixed(4)).join(' ')).join('L')}Z" />`,
      )}
    </svg>`;
}

const light: Vec3 = unit([0.2, 0.9, 0.5]);
