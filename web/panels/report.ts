import { html, nothing, type TemplateResult } from 'lit';
import type { Project } from '../../src/editor/project.ts';
import { remarks } from '../../src/mesh/report-sentences.ts';

const count = new Intl.NumberFormat('en');

/** What the mesh is like, in numbers and in words that say whether it matters. */
export function meshReport({ report, mesh, source }: Project): TemplateResult {
  const rows: readonly (readonly [string, number | string])[] = [
    ['Vertices', report.vertices],
    ['Faces', report.faces],
    ['Parts', report.components],
    ['Boundary edges', report.boundaryEdges],
    ['Non-manifold edges', report.nonManifoldEdges],
    ['Texture coordinates', mesh.uvs ? 'yes' : 'no'],
    ['Format', source.format],
  ];
  const sentences = remarks(report, mesh.uvs !== undefined);
  return html`
    <details class="report">
      <summary><span>About this mesh</span><small>${count.format(report.faces)} faces</small></summary>
      <dl>${rows.map(([name, value]) => html`<div data-row=${name}><dt>${name}</dt><dd>${typeof value === 'number' ? count.format(value) : value}</dd></div>`)}</dl>
      ${sentences.length > 0 ? html`<ul>${sentences.map((remark) => html`<li>${remark}</li>`)}</ul>` : nothing}
    </details>
  `;
}
