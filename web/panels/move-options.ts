import { html, nothing } from 'lit';
import { centerIn, type HandleGroup, targetCenter } from '../../src/editor/handle-groups.ts';
import { restShapeOf } from '../../src/editor/project.ts';
import { diagonalOf } from '../../src/mesh/extent.ts';
import { subtract, type Vec3 } from '../../src/mesh/vectors.ts';
import type { GizmoMode } from '../../src/viewer/gizmo.ts';
import type { Page } from '../app/actions.ts';
import type { MoveMode } from '../tools/handle-layers.ts';
import type { MoveHandles } from '../tools/move-handles.ts';
import type { TakeWay } from '../tools/taking.ts';
import { icon } from './icons.ts';

const modes: readonly { id: MoveMode; title: string; does: string }[] = [
  { id: 'pull', title: 'Pull', does: 'Press on the mesh and drag: what is under the brush comes along.' },
  { id: 'hold', title: 'Hold', does: 'Paint what has to stay as it was in the file.' },
  { id: 'let-go', title: 'Let go', does: 'Paint what is to be free again.' },
];

const takes: readonly { id: TakeWay; title: string; does: string }[] = [
  { id: 'side', title: 'Side', does: 'A whole side, edge or rim of the shape' },
  { id: 'spot', title: 'Brush', does: 'What is under a round brush' },
];

/** What pressing does where whole sides are taken. */
const sideDoes: Readonly<Record<MoveMode, string>> = {
  pull: 'Press on a side and drag it in or out. A click takes hold of it; Shift holds it still.',
  hold: 'Click the sides that have to stay as they were in the file.',
  'let-go': 'Click what is to be free again.',
};

const ways: readonly { id: GizmoMode; title: string; key: string }[] = [
  { id: 'translate', title: 'Move', key: 'G' },
  { id: 'rotate', title: 'Turn', key: 'R' },
  { id: 'scale', title: 'Scale', key: 'S' },
];

/** What the tool that moves does, the group it has hold of, and all that is held and moved. */
export function moveOptions(page: Page, tool: MoveHandles) {
  const { handles } = page;
  if (handles.parameter === undefined) return unable();
  const { mode, mirror } = tool.options;
  const { does } = modes.find(({ id }) => id === mode)!;
  const isSide = tool.take === 'side';
  return html`
    <h2>${tool.typed ? tool.typed.sentence : 'Hold and pull'}</h2>
    <p>${tool.typed ? 'X, Y, Z for an axis, digits for how far, Enter to keep.' : isSide ? sideDoes[mode] : does}</p>
    <div class="row" role="group" aria-label="What pressing does">
      ${modes.map(
        ({ id, title, does: hint }) =>
          html`<button type="button" class="button small" data-mode=${id} aria-pressed=${mode === id} title=${hint} @click=${() => tool.set({ mode: id })}>${title}</button>`,
      )}
    </div>
    <div class="row" role="group" aria-label="What is taken">
      ${takes.map(
        ({ id, title, does: hint }) =>
          html`<button type="button" class="button small" data-take=${id} aria-pressed=${tool.take === id} title=${hint} @click=${() => tool.set({ take: id })}>${title}</button>`,
      )}
    </div>
    ${isSide ? straight(tool) : size(tool)}
    <label class="field" title="What is done on the left is done on the right"><span>Mirror</span>
      <input type="checkbox" .checked=${mirror} @change=${(event: Event) => tool.set({ mirror: (event.target as HTMLInputElement).checked })} /></label>
    ${handles.active ? activeGroup(page, tool, handles.active) : nothing}
    ${handles.groups.length > 0 ? list(page) : nothing}
  `;
}

function size(tool: MoveHandles) {
  const { size } = tool.options;
  return html`
    <label class="field"><span>Size</span>
      <input type="range" class="plain" min="0.01" max="0.3" step="0.005" .value=${String(size)} aria-valuetext="${Math.round(100 * size)} percent of the mesh" @input=${(event: Event) => tool.set({ size: (event.target as HTMLInputElement).valueAsNumber })} /></label>`;
}

function straight(tool: MoveHandles) {
  return html`
    <label class="field" title="A side that is pulled goes in and out and not sideways"><span>Straight out</span>
      <input type="checkbox" data-act="straight-out" .checked=${tool.options.straight} @change=${(event: Event) => tool.set({ straight: (event.target as HTMLInputElement).checked })} /></label>`;
}

function unable() {
  return html`
    <h2>Hold and pull</h2>
    <p>This step holds nothing. Add a step that does, and pull what it left.</p>`;
}

/** A share of the mesh’s diagonal: what is less is rounding, of which nobody wants to read. */
const smallestTold = 1e-6;

function activeGroup(page: Page, tool: MoveHandles, group: HandleGroup) {
  const by = displacement(page, group);
  const least = smallestTold * diagonalOf(page.store.state.project!.mesh);
  const told = (value: number) => (Math.abs(value) < least ? '0' : String(Number(value.toPrecision(4))));
  return html`
    <div class="row" role="group" aria-label="What the gizmo does">
      ${ways.map(
        ({ id, title, key }) =>
          html`<button type="button" class="button small" data-way=${id} aria-pressed=${tool.options.gizmo === id} title="${title} (${key} to do it by keys)" @click=${() => tool.set({ gizmo: id })}>${title}</button>`,
      )}
    </div>
    <label class="field" title="The gizmo’s axes are the group’s own: the blue one leads out of the surface"><span>Own axes</span>
      <input type="checkbox" data-act="own-axes" .checked=${tool.options.ownAxes} @change=${(event: Event) => tool.set({ ownAxes: (event.target as HTMLInputElement).checked })} /></label>
    <div class="numbers" role="group" aria-label="How far ${group.name} has moved">
      ${(['x', 'y', 'z'] as const).map(
        (axis, k) =>
          html`<label><span>${axis}</span><input type="number" class="number" step="any" data-axis=${axis} .value=${told(by[k]!)} @change=${(event: Event) => tool.shift(along(k, (event.target as HTMLInputElement).valueAsNumber - by[k]!))} /></label>`,
      )}
    </div>`;
}

function list(page: Page) {
  const { handles } = page;
  const active = handles.active?.name;
  return html`
    <ul class="groups" aria-label="Held and moved">
      ${handles.groups.map(
        (group) => html`
          <li ?data-moved=${group.isMoved || group.name === active}>
            <button type="button" class="group-name" aria-pressed=${group.name === active} @click=${() => handles.activate(group.name === active ? null : group.name)}>${group.name}</button>
            <button type="button" class="step-act" aria-label="Let ${group.name} go" title="Let it go" @click=${() => handles.letGo(group.vertices)}>${icon('close')}</button>
          </li>`,
      )}
    </ul>
    <div class="row"><button type="button" class="button small" data-act="let-all-go" @click=${() => handles.letAllGo()}>Let all go</button></div>`;
}

/** From where the group was at rest to where it is to go. */
function displacement({ handles, store }: Page, { vertices }: HandleGroup): Vec3 {
  const project = store.state.project!;
  const rest = restShapeOf(project, project.active);
  return rest ? subtract(targetCenter(handles.handles, vertices), centerIn(rest, vertices)) : [0, 0, 0];
}

function along(axis: number, by: number): Vec3 {
  const way: [number, number, number] = [0, 0, 0];
  if (Number.isFinite(by)) way[axis] = by;
  return way;
}
