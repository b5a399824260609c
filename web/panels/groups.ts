import { html, nothing } from 'lit';
import type { Group } from '../../src/recipe/index.ts';
import { icon } from './icons.ts';
import { PageElement } from './page-element.ts';

const count = new Intl.NumberFormat('en');

/** The named groups: to be selected, changed, renamed and forgotten. */
export class WhittleGroups extends PageElement {
  /** The group whose name is being typed. */
  #renaming: string | null = null;

  protected override render() {
    const groups = this.state.project?.groups ?? [];
    const isEmpty = (this.state.select.selection?.count ?? 0) === 0;
    return html`
      <form class="name-group" @submit=${this.#name}>
        <label><span class="unseen">Name for what is selected</span>
          <input class="text" name="name" placeholder="Give it a name" autocomplete="off" maxlength="60" ?disabled=${isEmpty} /></label>
        <button class="button small" data-act="name-group" ?disabled=${isEmpty}>Keep</button>
      </form>
      ${groups.length > 0 ? html`<ul class="named-groups" aria-label="Groups">${groups.map((group) => this.#row(group, isEmpty))}</ul>` : nothing}
    `;
  }

  protected override updated(): void {
    const field = this.querySelector<HTMLInputElement>('.rename');
    if (field && !field.matches(':focus')) field.select();
  }

  #row({ name, vertices }: Group, isEmpty: boolean) {
    const { selecting } = this.page;
    const button = (
      act: string,
      label: string,
      face: Parameters<typeof icon>[0],
      run: () => void,
      disabled = false,
    ) =>
      html`<button type="button" class="button bare" data-act=${act} aria-label="${label} “${name}”" title="${label} “${name}”" ?disabled=${disabled} @click=${run}>${icon(face)}</button>`;
    return html`
      <li>
        ${
          this.#renaming === name
            ? html`<input class="text rename" .value=${name} aria-label="New name for “${name}”" maxlength="60" @keydown=${this.#typeName} @blur=${this.#endRenaming} />`
            : html`<button type="button" class="button take" data-act="take-group" title="Select “${name}”; with Shift put it to what is selected, with Ctrl take it away" @click=${(event: MouseEvent) => this.#take(name, event)}>
              <span>${name}</span><small>${count.format(vertices.length)}</small></button>`
        }
        ${button('add-to-group', 'Put what is selected to', 'add', () => selecting.changeGroup(name, 'add'), isEmpty)}
        ${button('take-from-group', 'Take what is selected out of', 'less', () => selecting.changeGroup(name, 'remove'), isEmpty)}
        ${button('rename-group', 'Rename', 'pencil', () => this.#rename(name))}
        ${button('forget-group', 'Forget', 'close', () => selecting.forget(name))}
      </li>
    `;
  }

  readonly #name = (event: SubmitEvent): void => {
    event.preventDefault();
    const field = (event.target as HTMLFormElement).elements.namedItem('name') as HTMLInputElement;
    if (this.page.selecting.name(field.value) === null) return;
    field.value = '';
    // The field is where one would go on; the canvas is where the keys are.
    field.blur();
  };

  #take(name: string, { shiftKey, ctrlKey, metaKey }: MouseEvent): void {
    const toggle = this.state.select.combination;
    this.page.selecting.take(name, shiftKey ? 'add' : ctrlKey || metaKey ? 'remove' : toggle);
  }

  #rename(name: string | null): void {
    this.#renaming = name;
    this.requestUpdate();
  }

  readonly #typeName = (event: KeyboardEvent): void => {
    if (event.key !== 'Enter' && event.key !== 'Escape') return;
    event.preventDefault();
    event.stopPropagation();
    const field = event.target as HTMLInputElement;
    if (event.key === 'Escape') field.value = this.#renaming ?? '';
    field.blur();
  };

  readonly #endRenaming = (event: Event): void => {
    const from = this.#renaming;
    this.#rename(null);
    if (from !== null) this.page.selecting.rename(from, (event.target as HTMLInputElement).value);
  };
}

customElements.define('whittle-groups', WhittleGroups);
