import type { ScreenPoint } from '../../src/selection/index.ts';

const svg = 'http://www.w3.org/2000/svg';

/** What a person draws on the canvas to select: a lasso, a frame, the ring of a brush. It says nothing to a screen reader. */
export class SelectInk {
  readonly #sheet: SVGSVGElement;
  readonly #outline: SVGPolygonElement;
  readonly #ring: SVGCircleElement;

  constructor(canvas: HTMLElement) {
    const page = canvas.ownerDocument;
    this.#sheet = page.createElementNS(svg, 'svg');
    this.#sheet.classList.add('select-ink');
    this.#sheet.ariaHidden = 'true';
    this.#outline = page.createElementNS(svg, 'polygon');
    this.#ring = page.createElementNS(svg, 'circle');
    this.#sheet.append(this.#outline, this.#ring);
    canvas.after(this.#sheet);
    this.outline([]);
    this.ring(null, 0);
  }

  outline(points: readonly ScreenPoint[]): void {
    this.#outline.style.display = points.length > 1 ? '' : 'none';
    this.#outline.setAttribute('points', points.map(([x, y]) => `${x},${y}`).join(' '));
  }

  ring(center: ScreenPoint | null, radius: number): void {
    this.#ring.style.display = center ? '' : 'none';
    if (!center) return;
    this.#ring.setAttribute('cx', String(center[0]));
    this.#ring.setAttribute('cy', String(center[1]));
    this.#ring.setAttribute('r', String(radius));
  }

  clear(): void {
    this.outline([]);
    this.ring(null, 0);
  }
}
