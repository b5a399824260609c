import { html, nothing } from 'lit';
import type { Vec3 } from '../../src/mesh/vectors.ts';
import type { ChoiceParameter } from '../../src/methods/values/choice.ts';
import type { Page } from '../app/actions.ts';
import type { CubeActions } from '../app/cube-actions.ts';
import { icon } from './icons.ts';
import { zonotopePicture } from './zonotope-picture.ts';

/** What the mesh is drawn to: which polyhedron, how it is stretched, and the regions that have one of their own. */
export function cubeOptions({ cube }: Page) {
  if (!cube.isTurnable) {
    return html`
      <h2>Cube</h2>
      <p>This step has no cube to turn. Choose a style that carves.</p>`;
  }
  return html`
    <h2>Cube</h2>
    <p>Drag a ring to turn it${cube.isBox && cube.region === null ? ', an arrow to stretch it' : ''}.</p>
    <div class="row"><button type="button" class="button small" data-act="straighten" @click=${() => cube.straighten()}>${icon('reset')}Straighten</button></div>
    ${cube.polyhedron ? pictures(cube, cube.polyhedron) : nothing}
    ${cube.isBox && cube.region === null ? stretches(cube) : nothing}
    ${cube.takesRegions ? regions(cube) : nothing}
  `;
}

function pictures(cube: CubeActions, { choices, rows = {} }: ChoiceParameter) {
  const { chosen } = cube;
  const isOwn = typeof chosen !== 'string';
  return html`
    <div class="pictures" role="group" aria-label="Polyhedron">
      ${choices.map(
        (name) =>
          html`<button type="button" class="picture" data-polyhedron=${name} aria-pressed=${chosen === name} aria-label=${spoken(name)} title=${spoken(name)} @click=${() => cube.choose(name)}>${zonotopePicture((rows[name] ?? []) as readonly Vec3[])}</button>`,
      )}
      <button type="button" class="picture" data-polyhedron="own" aria-pressed=${isOwn} aria-label="Edges of your own" title="Edges of your own" @click=${() => isOwn || cube.choose(cube.rows)}>${isOwn ? zonotopePicture(cube.rows) : icon('add')}</button>
    </div>
    ${isOwn ? ownRows(cube, chosen as readonly Vec3[]) : nothing}`;
}

/** Edges as rows of three numbers: the polyhedron is what they span. */
function ownRows(cube: CubeActions, rows: readonly Vec3[]) {
  const most = cube.polyhedron?.maxRows ?? rows.length;
  const change = (index: number, axis: number, value: number) => {
    if (!Number.isFinite(value)) return;
    cube.choose(rows.map((row, k) => (k === index ? (row.with(axis, value) as unknown as Vec3) : row)));
  };
  return html`
    <div class="own-rows" role="group" aria-label="Its edges: direction and length">
      ${rows.map(
        (row, index) => html`
          <div class="own-row">
            ${row.map(
              (value, axis) =>
                html`<input type="number" class="number" step="0.1" data-row=${index} data-axis=${axis} aria-label="Edge ${index + 1}, ${'xyz'[axis]}" .value=${String(Number(value.toFixed(4)))} @change=${(event: Event) => change(index, axis, (event.target as HTMLInputElement).valueAsNumber)} />`,
            )}
            <button type="button" class="step-act" ?disabled=${rows.length < 2} aria-label="Remove edge ${index + 1}" title="Remove it" @click=${() => cube.choose(rows.filter((_, k) => k !== index))}>${icon('close')}</button>
          </div>`,
      )}
    </div>
    <div class="row"><button type="button" class="button small" data-act="add-edge" ?disabled=${rows.length >= most} @click=${() => cube.choose([...rows, [0.5, 0.5, 0.5]])}>${icon('add')}Add an edge</button></div>`;
}

function stretches(cube: CubeActions) {
  const { axes } = cube;
  return html`
    <div class="numbers" role="group" aria-label="How much it is stretched">
      ${(['x', 'y', 'z'] as const).map(
        (axis, k) =>
          html`<label><span>${axis}</span><input type="number" class="number" min="0" max="100" step="0.1" data-stretch=${axis} .value=${String(axes[k])} @change=${(event: Event) => stretch(cube, k, (event.target as HTMLInputElement).valueAsNumber)} /></label>`,
      )}
    </div>`;
}

function stretch(cube: CubeActions, axis: number, value: number): void {
  if (value >= 0 && value <= 100) cube.stretch(cube.axes.with(axis, value) as unknown as Vec3, true);
}

function regions(cube: CubeActions) {
  const list = cube.regions;
  if (list.length === 0) return html`<p>To turn the cube of one part only, select the part first.</p>`;
  const face = (index: number | null, title: string) =>
    html`<button type="button" class="group-name" data-region=${index ?? 'rest'} aria-pressed=${cube.region === index} @click=${() => cube.chooseRegion(index)}>${title}</button>`;
  return html`
    <ul class="groups" aria-label="Cubes">
      <li>${face(null, list.length > 0 ? 'All the rest' : 'All')}</li>
      ${list.map(
        ({ vertices }, index) => html`
          <li>${face(index, `Part ${index + 1}, ${vertices.length} vertices`)}
            <button type="button" class="step-act" aria-label="Remove the cube of part ${index + 1}" title="Remove it" @click=${() => cube.removeRegion(index)}>${icon('close')}</button></li>`,
      )}
    </ul>`;
}

function spoken(name: string): string {
  const words = name.replaceAll('-', ' ');
  return words.charAt(0).toUpperCase() + words.slice(1);
}
