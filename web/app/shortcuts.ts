import type { Page } from './actions.ts';

export interface Shortcut {
  /** As `KeyboardEvent.key`, lower case. */
  readonly key: string;
  readonly label: string;
  readonly does: string;
  readonly run: (page: Page) => void;
  /** What letting go does. */
  readonly release?: (page: Page) => void;
}

/** Single keys, in the order in which the help lists them. */
export const shortcuts: readonly Shortcut[] = [
  { key: 'o', label: 'O', does: 'Open a file', run: (page) => page.pickFile() },
  { key: 'e', label: 'E', does: 'Export', run: (page) => void page.export() },
  {
    key: 'b',
    label: 'B',
    does: 'Hold to see the original',
    run: (page) => page.look({ comparing: true }),
    release: (page) => page.look({ comparing: false }),
  },
  { key: '1', label: '1', does: 'Smooth shading', run: (page) => page.look({ shading: 'smooth' }) },
  { key: '2', label: '2', does: 'Flat shading', run: (page) => page.look({ shading: 'flat' }) },
  { key: '3', label: '3', does: 'Wireframe', run: (page) => page.look({ shading: 'wire' }) },
  { key: 'f', label: 'F', does: 'Fit the view', run: (page) => page.fit() },
  {
    key: 'n',
    label: 'N',
    does: 'Compare choices side by side',
    run: (page) => page.comparing.toggle(),
  },
  { key: 'r', label: 'R', does: 'Reset the method', run: (page) => void page.editor.reset() },
  { key: 'p', label: 'P', does: 'Save a picture', run: (page) => void page.saveSnapshot() },
];

/** Listens for keys everywhere but where text is typed. `help` opens the list of keys. */
export function listenForShortcuts(page: Page, help: () => void, target: Document = document): () => void {
  const off = new AbortController();
  const down = (event: KeyboardEvent) => {
    if (event.defaultPrevented || event.isComposing || isTyping(event) || inDialog(target)) return;
    if (runCommand(event, page, help)) event.preventDefault();
  };
  const up = (event: KeyboardEvent) => byKey(event)?.release?.(page);
  target.addEventListener('keydown', down, { signal: off.signal });
  target.addEventListener('keyup', up, { signal: off.signal });
  globalThis.addEventListener?.('blur', () => page.look({ comparing: false }), { signal: off.signal });
  return () => off.abort();
}

function runCommand(event: KeyboardEvent, page: Page, help: () => void): boolean {
  const key = event.key.toLowerCase();
  if (event.ctrlKey || event.metaKey) {
    if (key === 'z') return event.shiftKey ? page.editor.redo() : page.editor.undo();
    if (key === 'y') return page.editor.redo();
    return false;
  }
  if (page.tools.key(event)) return true;
  if (event.altKey) return false;
  if (key === 'escape') return page.editor.cancel() || dismissNotice(page) || page.comparing.leave();
  if (key === '?') {
    help();
    return true;
  }
  const shortcut = byKey(event);
  if (!shortcut || event.repeat) return shortcut !== undefined;
  shortcut.run(page);
  return true;
}

function dismissNotice(page: Page): boolean {
  if (!page.store.state.notice) return false;
  page.dismiss();
  return true;
}

function byKey(event: KeyboardEvent): Shortcut | undefined {
  return shortcuts.find(({ key }) => key === event.key.toLowerCase());
}

/** Where letters are meant for the field; sliders, switches and boxes have no use for them. */
const typing = 'input:not([type=range], [type=radio], [type=checkbox]), textarea, select, [contenteditable]';

function isTyping({ target }: KeyboardEvent): boolean {
  const element = target as { matches?: (selector: string) => boolean } | null;
  return element?.matches?.(typing) ?? false;
}

function inDialog(target: Document): boolean {
  return target.querySelector?.('dialog[open]') !== null;
}
