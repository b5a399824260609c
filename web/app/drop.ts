import type { Page } from './actions.ts';
import { filesOfDrop } from './found-files.ts';

/**
 * Makes the whole window a place to drop files: for meshes to carve, over the styles for styles and over the images for images.
 * `body[data-dropping]` says which, while files hover over it.
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
    body.dataset.dropping = goods(event);
  });
  target.addEventListener('dragover', (event) => {
    if (!hasFiles(event)) return;
    event.preventDefault();
    event.dataTransfer!.dropEffect = 'copy';
    body.dataset.dropping = goods(event);
  });
  target.addEventListener('dragleave', (event) => {
    if (hasFiles(event) && --depth <= 0) end();
  });
  target.addEventListener('drop', (event) => {
    if (!hasFiles(event)) return;
    event.preventDefault();
    end();
    const place = goods(event);
    void filesOfDrop(event.dataTransfer!).then((files) => {
      const take = {
        style: () => page.addStyles(files),
        image: () => page.images.add(files),
        mesh: () => page.openFiles(files),
      };
      // Saved work is itself wherever it falls.
      const isWork = files.some(({ name }) => /\.whittle\.(json|zip)$/i.test(name));
      return take[isWork ? 'mesh' : place]();
    });
  });
}

function hasFiles(event: DragEvent): boolean {
  return event.dataTransfer?.types.includes('Files') ?? false;
}

/** What the place under the files takes them for. */
function goods({ target }: DragEvent): 'mesh' | 'style' | 'image' {
  if (!(target instanceof Element)) return 'mesh';
  if (target.closest('[data-takes-images]')) return 'image';
  return target.closest('[data-takes-styles]') ? 'style' : 'mesh';
}
