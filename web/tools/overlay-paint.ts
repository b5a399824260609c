import type { Viewer } from '../../src/viewer/viewer.ts';
import type { WhittleDocument } from '../document/document.ts';
import { measure, type Overlay } from '../document/overlays.ts';
import { rampColors } from '../document/ramp.ts';
import type { OverlayName, Store } from '../document/store.ts';

/** Keeps the colours on the mesh those of the chosen overlay; they follow the document, not single frames of a run. */
export function followOverlay(store: Store, viewer: Viewer | null): void {
  let shown: { document: WhittleDocument; name: OverlayName } | null = null;
  let isSet = false;
  store.subscribe(({ document, look, overlay }) => {
    if (!document || (shown?.document === document && shown.name === look.overlay)) return;
    shown = { document, name: look.overlay };
    const next: Overlay | null = measure(document, look.overlay);
    if (next || isSet) viewer?.setColors(next && rampColors(next.values, next.max));
    isSet = next !== null;
    if (next !== overlay) store.set({ overlay: next });
  });
}
