import { html, nothing, type TemplateResult } from 'lit';
import type { WhittleDocument } from '../document/document.ts';

const count = new Intl.NumberFormat('en');

/** What the mesh is like, in numbers and in words that say whether it matters. */
export function meshReport({ report, mesh, source }: WhittleDocument): TemplateResult {
  const rows: readonly (readonly [string, number | string])[] = [
    ['Vertices', report.vertices],
    ['Faces', report.faces],
    ['Parts', report.components],
    ['Boundary edges', report.boundaryEdges],
    ['Non-manifold edges', report.nonManifoldEdges],
    ['Texture coordinates', mesh.uvs ? 'yes' : 'no'],
    ['Format', source.format],
  ];
  const remarks = remarksOn(report, mesh.uvs !== undefined);
  return html`
    <details class="report">
      <summary><span>About this mesh</span><small>${count.format(report.faces)} faces</small></summary>
      <dl>${rows.map(([name, value]) => html`<div data-row=${name}><dt>${name}</dt><dd>${typeof value === 'number' ? count.format(value) : value}</dd></div>`)}</dl>
      ${remarks.length > 0 ? html`<ul>${remarks.map((remark) => html`<li>${remark}</li>`)}</ul>` : nothing}
    </details>
  `;
}

/** Sentences about what a person may wonder about; none for a plain closed mesh. */
export function remarksOn(report: WhittleDocument['report'], hasUvs: boolean): string[] {
  const remarks: string[] = [];
  const say = (number: number, sentence: (n: string) => string) => {
    if (number > 0) remarks.push(sentence(count.format(number)));
  };
  say(
    report.components - 1,
    () => `It has ${count.format(report.components)} separate parts; each is shaped on its own.`,
  );
  say(report.boundaryEdges, (n) => `${n} boundary edges: the surface is open somewhere. That is fine.`);
  say(
    report.nonManifoldEdges,
    (n) => `${n} edges have more than two faces. They are kept and shaped with the rest.`,
  );
  say(report.degenerateFaces, (n) => `${n} faces have no area. They are kept and do no harm.`);
  say(report.duplicateFaces, (n) => `${n} faces appear twice. They are kept as they are.`);
  say(report.isolatedVertices, (n) => `${n} vertices belong to no face and stay where they are.`);
  if (hasUvs) remarks.push('Its texture coordinates go home unchanged.');
  return remarks;
}
