import type { WhittleDocument } from '../../src/editor/project.ts';
import { measure, type OverlayName } from '../../src/measures/index.ts';
import type { Viewer } from '../../src/viewer/viewer.ts';
import { rampColors } from './color-ramp.ts';
import type { Store } from './store.ts';

/** Keeps the colours on the mesh those of the chosen overlay; they follow the document, not single frames of a run. */
export function followOverlay(store: Store, viewer: Pick<Viewer, 'setColors'> | null): void {
  let shown: { document: WhittleDocument; name: OverlayName; comparing: boolean } | null = null;
  let isSet = false;
  store.subscribe(({ document, look: { overlay: name, comparing }, overlay }) => {
    if (!document || (shown?.document === document && shown.name === name && shown.comparing === comparing))
      return;
    shown = { document, name, comparing };
    const next = measure(document, name, comparing);
    if (next || isSet) viewer?.setColors(next && rampColors(next.scale, next.values));
    isSet = next !== null;
    if (next !== overlay) store.set({ overlay: next });
  });
}
