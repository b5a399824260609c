import { measuredOf } from '../../src/editor/measured.ts';
import type { Project } from '../../src/editor/project.ts';
import { measure, type OverlayName } from '../../src/measures/index.ts';
import type { Viewer } from '../../src/viewer/viewer.ts';
import { rampColors } from './color-ramp.ts';
import type { PageStore } from './page-state.ts';

/** Keeps the colours on the mesh those of the chosen overlay; they follow the project, not single frames of a run. */
export function followOverlay(store: PageStore, viewer: Pick<Viewer, 'setColors'> | null): void {
  let shown: { project: Project; name: OverlayName; comparing: boolean } | null = null;
  let isSet = false;
  store.subscribe(({ project, look: { overlay: name, comparing }, overlay }) => {
    if (!project || (shown?.project === project && shown.name === name && shown.comparing === comparing))
      return;
    shown = { project, name, comparing };
    const next = name === 'none' ? null : measure(measuredOf(project), name, comparing);
    if (next || isSet) viewer?.setColors(next && rampColors(next.scale, next.values));
    isSet = next !== null;
    if (next !== overlay) store.set({ overlay: next });
  });
}
