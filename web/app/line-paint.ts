import { measuredOf } from '../../src/editor/measured.ts';
import type { Project } from '../../src/editor/project.ts';
import { type LineField, linesFor } from '../../src/measures/index.ts';
import type { Layers } from '../../src/viewer/layers/layers.ts';
import type { PageStore } from './page-state.ts';

/** What lines of a method are drawn in, one after the other. */
const colors = ['#0c8f7d', '#7b3fe4', '#2f7de1', '#c2560c'] as const;

/** By the place of the lines among all that the method has, so that they keep it whatever else is drawn. */
export function lineColor(all: readonly LineField[], name: string): string {
  return colors[
    Math.max(
      0,
      all.findIndex((one) => one.name === name),
    ) % colors.length
  ]!;
}

/** Keeps the lines over the mesh those that are chosen; they follow the project, not single frames of a run. */
export function followLines(store: PageStore, layers: Layers | null): void {
  let shown: { project: Project; names: readonly string[] } | null = null;
  let drawn: readonly string[] = [];
  store.subscribe(({ project, look: { lines: names }, lines }) => {
    if (!project || (shown?.project === project && shown.names === names)) return;
    shown = { project, names };
    if (names.length === 0 && lines.length === 0) return;
    const all = linesFor(measuredOf(project));
    const next = all.filter(({ name }) => names.includes(name));
    for (const name of drawn) layers?.set(name, null);
    drawn = next.map(({ name }) => `found ${name}`);
    for (const { name, values: positions } of next)
      layers?.set(`found ${name}`, {
        ...{ kind: 'lines', positions, width: 2.5, depth: 'faint-behind' },
        color: lineColor(all, name),
      });
    store.set({ lines: next });
  });
}
