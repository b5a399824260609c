import { html, type TemplateResult } from 'lit';

const width = 84;
const height = 22;

/** A falling energy as a small curve: by the root of its height above the lowest, so that the slow end still shows. */
export function sparkline(energy: readonly number[]): TemplateResult {
  return html`<svg class="sparkline" viewBox="0 0 ${width} ${height}" width=${width} height=${height} aria-hidden="true"><polyline points=${curve(energy)} /></svg>`;
}

export function curve(energy: readonly number[]): string {
  if (energy.length < 2) return '';
  let low = Infinity;
  let high = -Infinity;
  for (const value of energy) {
    if (value < low) low = value;
    if (value > high) high = value;
  }
  const span = high - low || 1;
  const steps = Math.min(60, energy.length - 1);
  const points = Array.from({ length: steps + 1 }, (_, i) => {
    const value = energy[Math.round((i / steps) * (energy.length - 1))]!;
    const x = (i / steps) * (width - 4) + 2;
    const y = height - 3 - Math.sqrt((value - low) / span) * (height - 6);
    return `${x.toFixed(1)},${y.toFixed(1)}`;
  });
  return points.join(' ');
}
