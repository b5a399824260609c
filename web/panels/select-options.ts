import { html, nothing, type TemplateResult } from 'lit';
import { live } from 'lit/directives/live.js';
import type { Page } from '../app/actions.ts';
import { brushSizes, type SelectWay } from '../app/select-state.ts';
import { selectionSentence } from '../app/selecting.ts';
import './groups.ts';
import { icon } from './icons.ts';
import { planeList } from './planes.ts';
import { selectionUses } from './selection-uses.ts';

const ways: readonly { readonly id: SelectWay; readonly title: string; readonly hint: string }[] = [
  {
    id: 'click',
    title: 'Click',
    hint: 'Point at a side, an edge or a rim. Drag to brush; Alt takes one vertex, a double click the whole part.',
  },
  { id: 'brush', title: 'Brush', hint: 'Drag over what you want. [ and ] change the size.' },
  { id: 'lasso', title: 'Lasso', hint: 'Draw a line around what you want.' },
  { id: 'box', title: 'Frame', hint: 'Drag a frame over what you want.' },
];

const combinations = [
  { id: 'replace', title: 'New', hint: 'Select this and nothing else' },
  { id: 'add', title: 'Add', hint: 'Put it to what is selected (Shift)' },
  { id: 'remove', title: 'Remove', hint: 'Take it from what is selected (Ctrl)' },
] as const;

const axes = ['X', 'Y', 'Z'] as const;

/** What can be set of the tool that selects, and done with what is selected. */
export function selectOptions(page: Page): TemplateResult {
  const { select } = page.store.state;
  const { selecting } = page;
  const way = ways.find(({ id }) => id === select.way)!;
  return html`
    <h2>Select</h2>
    <div class="select-way">
      ${choice('way', 'How', ways, select.way, (id) => selecting.set({ way: id, pointed: null }))}
      <button type="button" class="button bare unfold" aria-expanded=${select.isUnfolded} aria-label="More about selecting" @click=${() => selecting.set({ isUnfolded: !select.isUnfolded })}>${icon(select.isUnfolded ? 'up' : 'down')}</button>
    </div>
    <p>${way.hint}</p>
    ${choice('combination', 'What is selected already', combinations, select.combination, (id) => selecting.set({ combination: id }))}
    ${select.way === 'click' ? html`<p class="pointed" aria-live="polite">${select.pointed ? `A click takes ${select.pointed}.` : nothing}</p>` : nothing}
    ${said(page)}
    <div class="select-more" ?data-unfolded=${select.isUnfolded}>
      ${select.way === 'click' || select.way === 'brush' ? size(page) : nothing}
      ${select.way === 'click' ? edges(page) : through(page)}
      ${changes(page)}
      ${selectionUses(page)}
      ${planeList(page)}
      <whittle-groups .page=${page}></whittle-groups>
    </div>
  `;
}

function said({ store, selecting }: Page) {
  const { selection, remark } = store.state.select;
  const sentence = selection && selecting.surface ? selectionSentence(selection) : 'Looking at the mesh …';
  return html`<p class="selected" role="status">${sentence}${remark ? ` ${remark}` : nothing}</p>`;
}

function changes({ selecting, store }: Page) {
  const { selection } = store.state.select;
  const isEmpty = !selection || selection.count === 0;
  const button = (act: string, title: string, does: string, run: () => unknown, disabled = isEmpty) =>
    html`<button type="button" class="button small" data-act=${act} title=${does} ?disabled=${disabled} @click=${run}>${title}</button>`;
  return html`
    <div class="row" role="group" aria-label="Change the selection">
      ${button('select-all', 'All', 'Select everything (A)', () => selecting.all(), !selection)}
      ${button('select-none', 'None', 'Select nothing (Esc)', () => selecting.none())}
      ${button('invert', 'Invert', 'Select the rest instead (I)', () => selecting.invert(), !selection)}
      ${button('grow', 'Grow', 'Take the neighbours too (.)', () => selecting.grow())}
      ${button('shrink', 'Shrink', 'Leave out those at the rim (,)', () => selecting.shrink())}
    </div>
    <div class="row mirror" role="group" aria-label="Select the mirror image too">
      <span aria-hidden="true">Mirror</span>
      ${axes.map((axis, k) => html`<button type="button" class="button small" data-act="mirror-${axis.toLowerCase()}" aria-label="Mirror across ${axis}" title="Select what lies opposite along ${axis} too (M: where the mesh is symmetric)" ?disabled=${isEmpty} @click=${() => void selecting.mirror(k as 0 | 1 | 2)}>${axis}</button>`)}
    </div>
  `;
}

function size({ store, selecting }: Page) {
  const { brush } = store.state.select;
  return html`
    <label class="field"><span>Size</span>
      <input type="range" class="plain" min=${brushSizes.least} max=${brushSizes.most} step="1" .value=${live(String(brush))} aria-valuetext="${2 * brush} pixels across" @input=${(event: Event) => selecting.set({ brush: (event.target as HTMLInputElement).valueAsNumber })} /></label>
  `;
}

/** From which bend on an edge ends what a click takes. */
function edges({ store, selecting }: Page) {
  const { angle } = store.state.select;
  return html`
    <label class="field" title="Edges that bend by less are part of a smooth side"><span>Edges from ${angle}°</span>
      <input type="range" class="plain" min="10" max="80" step="5" .value=${live(String(angle))} aria-valuetext="${angle} degrees" @input=${(event: Event) => selecting.set({ angle: (event.target as HTMLInputElement).valueAsNumber })} /></label>
  `;
}

function through({ store, selecting }: Page) {
  return html`
    <label class="field" title="Take what is hidden behind too"><span>Far side too</span>
      <input type="checkbox" .checked=${live(store.state.select.through)} @change=${(event: Event) => selecting.set({ through: (event.target as HTMLInputElement).checked })} /></label>
  `;
}

function choice<Id extends string>(
  name: string,
  legend: string,
  entries: readonly { readonly id: Id; readonly title: string; readonly hint: string }[],
  chosen: Id,
  choose: (id: Id) => void,
) {
  return html`
    <fieldset class="choice"><legend class="unseen">${legend}</legend>
      ${entries.map(({ id, title, hint }) => html`<label title=${hint}><input type="radio" name="select-${name}" .value=${id} .checked=${live(id === chosen)} @change=${() => choose(id)} /><span>${title}</span></label>`)}
    </fieldset>
  `;
}
