import { html, nothing } from 'lit';
import type { Plane } from '../../src/methods/values/planes.ts';
import type { Page } from '../app/actions.ts';
import { icon } from './icons.ts';

const axes = ['x', 'y', 'z'] as const;

/** The planes that parts of the mesh are held on. */
export function planeList({ planes }: Page) {
  const list = planes.planes;
  if (list.length === 0) return nothing;
  return html`
    <ul class="planes" aria-label="Planes">
      ${list.map((plane, index) => {
        const axis = axisOf(plane);
        const name = `Plane ${index + 1}`;
        return html`
          <li>
            <select aria-label="How ${name} lies" @change=${(event: Event) => lay(planes.lay.bind(planes, index), (event.target as HTMLSelectElement).value)}>
              ${axes.map((one, k) => html`<option value=${k} ?selected=${axis === k}>across ${one}</option>`)}
              <option value="" ?selected=${axis === null}>as it lies</option>
            </select>
            <input type="number" class="number" step="any" aria-label="Where ${name} is, in the file’s units" .value=${String(Number(plane.offset.toPrecision(5)))} @change=${(event: Event) => planes.shift(index, (event.target as HTMLInputElement).valueAsNumber, true)} />
            <button type="button" class="button bare" data-act="remove-plane" aria-label="Remove ${name}" title="Let what is on it go" @click=${() => planes.remove(index)}>${icon('close')}</button>
          </li>`;
      })}
    </ul>
  `;
}

function lay(put: (axis: 0 | 1 | 2 | null) => void, value: string): void {
  put(value === '' ? null : (Number(value) as 0 | 1 | 2));
}

/** The axis that a plane lies across; null where it lies across none. */
function axisOf({ normal }: Plane): 0 | 1 | 2 | null {
  const size = Math.hypot(...normal);
  const axis = normal.findIndex((value) => Math.abs(value) > (1 - 1e-9) * size);
  return axis < 0 ? null : (axis as 0 | 1 | 2);
}
