import { WhittleView } from './whittle-view.ts';

export type { ViewEventMap } from './events.ts';
export { WhittleView };

// Without a DOM the module can be imported all the same; there is just nothing to define.
if (typeof customElements !== 'undefined' && !customElements.get('whittle-view'))
  customElements.define('whittle-view', WhittleView);

declare global {
  interface HTMLElementTagNameMap {
    'whittle-view': WhittleView;
  }
}
