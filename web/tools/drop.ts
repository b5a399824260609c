import type { Page } from './page.ts';

/** Makes the whole window a place to drop files. `body[data-dropping]` while files hover over it. */
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
    body.dataset.dropping = '';
  });
  target.addEventListener('dragover', (event) => {
    if (!hasFiles(event)) return;
    event.preventDefault();
    event.dataTransfer!.dropEffect = 'copy';
  });
  target.addEventListener('dragleave', (event) => {
    if (hasFiles(event) && --depth <= 0) end();
  });
  target.addEventListener('drop', (event) => {
    if (!hasFiles(event)) return;
    event.preventDefault();
    end();
    void page.openFiles([...event.dataTransfer!.files]);
  });
}

function hasFiles(event: DragEvent): boolean {
  return event.dataTransfer?.types.includes('Files') ?? false;
}
