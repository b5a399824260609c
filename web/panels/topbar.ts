import { html } from 'lit';
import { samples } from '../app/samples.ts';
import { nextTheme } from '../app/theme.ts';
import { icon } from './icons.ts';
import { PageElement } from './page-element.ts';
import './menu.ts';

const themeNames = { auto: 'as your system', light: 'light', dark: 'dark' } as const;

/** What there is to open, undo and redo, and the page's own matters. */
export class WhittleTopbar extends PageElement {
  protected override render() {
    const { history, look } = this.state;
    const { page } = this;
    const past = history.past.at(-1);
    const next = history.future[0];
    return html`
      <div class="group">
        <button type="button" class="button" data-act="open" title="Open a file (O), or drop one anywhere" aria-label="Open a file" @click=${() => page.pickFile()}>
          ${icon('open')}<span class="wide">Open</span>
        </button>
        <whittle-menu
          label="Samples" .face=${html`${icon('samples')}<span class="wide">Samples</span>`}
          .items=${samples.map((sample) => ({
            label: sample.title,
            about: sample.about,
            picture: `${import.meta.env.BASE_URL}thumbnails/${sample.file.replace(/\..*$/, '')}.webp`,
            run: () => void page.openSample(sample),
          }))}
        ></whittle-menu>
      </div>
      <div class="group">
        <button type="button" class="button" data-act="undo" ?disabled=${!past} aria-label=${past ? `Undo ${past.label}` : 'Undo'} title=${past ? `Undo ${past.label}` : 'Nothing to undo'} @click=${() => page.editor.undo()}>${icon('undo')}</button>
        <button type="button" class="button" data-act="redo" ?disabled=${!next} aria-label=${next ? `Redo ${next.label}` : 'Redo'} title=${next ? `Redo ${next.label}` : 'Nothing to redo'} @click=${() => page.editor.redo()}>${icon('redo')}</button>
      </div>
      <div class="group">
        <button type="button" class="button" data-act="theme" aria-label="Colours: ${themeNames[look.theme]}" title="Colours: ${themeNames[look.theme]}" @click=${() => page.look({ theme: nextTheme(look.theme) })}>${icon(look.theme)}</button>
        <button type="button" class="button" data-act="help" aria-label="Help and keys" title="Help and keys (?)" @click=${() => document.querySelector('whittle-help')?.dispatchEvent(new Event('open'))}>${icon('help')}</button>
      </div>
    `;
  }
}

customElements.define('whittle-topbar', WhittleTopbar);
