import type { ToolId } from '../tools/tool.ts';

/** What one has to know of a tool who takes it for the first time. */
const texts: Readonly<Record<ToolId, string>> = {
  turn: 'Pull the slider and watch. Drag the mesh to turn it.',
  select: 'Point at the mesh: what lights up is what a click takes. Shift adds to it.',
  move: 'Press on the mesh and pull: a part comes along, the rest follows.',
  lines: 'Point at an edge: what lights up is what a click marks. Another click takes the mark away.',
  paint: 'Paint on the mesh where the style is to be weaker. “More” brings it back.',
  cube: 'Drag the rings to turn the cube, and its sides to make it longer or shorter.',
};

const key = 'whittle-hints';

/** Hints that show until they are no longer needed, and then never again in this browser. */
export class Hints {
  readonly #known = new Set<string>(remembered());

  /** Null for what the person knows. */
  textFor(tool: ToolId): string | null {
    return this.#known.has(tool) ? null : texts[tool];
  }

  /** The person has used a tool, or has read its hint. */
  learn(tool: ToolId): void {
    if (this.#known.has(tool)) return;
    this.#known.add(tool);
    try {
      localStorage.setItem(key, JSON.stringify([...this.#known]));
    } catch {
      // A browser that keeps nothing shows them again.
    }
  }
}

function remembered(): readonly string[] {
  try {
    const known: unknown = JSON.parse(localStorage.getItem(key) ?? '[]');
    return Array.isArray(known) ? known : [];
  } catch {
    return [];
  }
}
