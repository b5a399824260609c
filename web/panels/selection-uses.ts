import { html, nothing } from 'lit';
import { translation } from '../../src/mesh/affine.ts';
import type { Page } from '../app/actions.ts';

/** What one can do with what is selected; what the active step cannot do is not offered. */
export function selectionUses(page: Page) {
  const { handles, planes, cube, store } = page;
  const count = store.state.select.selection?.count ?? 0;
  const button = (act: string, title: string, does: string, run: () => void) =>
    html`<button type="button" class="button small" data-act=${act} title=${does} ?disabled=${count === 0} @click=${run}>${title}</button>`;
  const takesHandles = handles.parameter !== undefined;
  const takesPlanes = planes.parameter !== undefined;
  if (!takesHandles && !takesPlanes && !cube.takesRegions) return nothing;
  return html`
    <div class="row uses" role="group" aria-label="Use what is selected">
      ${takesHandles ? button('hold-selected', 'Hold', 'Keep it as it was in the file', () => hold(page)) : nothing}
      ${takesHandles ? button('move-selected', 'Move', 'Take hold of it to move, turn or scale it', () => move(page)) : nothing}
      ${takesPlanes ? button('plane-selected', 'On a plane', 'Hold it on the plane that it lies nearest to', () => onPlane(page)) : nothing}
      ${cube.takesRegions ? button('cube-selected', 'Cube of its own', 'Draw it to a cube of its own, to be turned', () => ownCube(page)) : nothing}
    </div>
  `;
}

function hold({ handles, selecting }: Page): void {
  handles.hold(selecting.positions);
  selecting.set({ remark: 'It is held still.' });
}

function move({ handles, selecting, tools }: Page): void {
  const grip = handles.take(selecting.positions);
  handles.keep(grip, translation([0, 0, 0]), 'Take hold');
  tools.choose('move');
}

function onPlane({ planes, selecting }: Page): void {
  planes.hold(selecting.positions);
  selecting.set({ remark: 'It is held on a plane; drag the arrow to move it.' });
}

function ownCube({ cube, selecting, tools }: Page): void {
  cube.addRegion(selecting.positions);
  tools.choose('cube');
}
