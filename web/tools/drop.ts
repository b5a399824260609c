import type { Page } from './page.ts';

/**
 * Makes the whole window a place to drop files: for meshes to carve, and over the styles for styles. `body[data-dropping]` says
 * which, while files hover over it.
 */
export function listenForDrops(page: Page, target: Window = window): void {
  const { body } = target.document;
  let depth = 0;
  const end = () => {
    depth = 0;
    delete body.dataset.dropping;
  };
  target.addEventListener('dragenter', (event) => {
    if (!hasFiles(event)) return;
    event.preventDefault();
    depth++;
    body.dataset.dropping = isOverStyles(event) ? 'style' : 'mesh';
  });
  target.addEventListener('dragover', (event) => {
    if (!hasFiles(event)) return;
    event.preventDefault();
    event.dataTransfer!.dropEffect = 'copy';
    body.dataset.dropping = isOverStyles(event) ? 'style' : 'mesh';
  });
  target.addEventListener('dragleave', (event) => {
    if (hasFiles(event) && --depth <= 0) end();
  });
  target.addEventListener('drop', (event) => {
    if (!hasFiles(event)) return;
    event.preventDefault();
    end();
    const files = [...event.dataTransfer!.files];
    void (isOverStyles(event) ? page.addStyles(files) : page.openFiles(files));
  });
}

function hasFiles(event: DragEvent): boolean {
  return event.dataTransfer?.types.includes('Files') ?? false;
}

function isOverStyles({ target }: DragEvent): boolean {
  return target instanceof Element && target.closest('[data-takes-styles]') !== null;
}
