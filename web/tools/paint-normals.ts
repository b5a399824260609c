import type { Editor } from '../../src/editor/editor.ts';
import { freeName } from '../../src/editor/free-name.ts';
import { activeStep } from '../../src/editor/project.ts';
import { styleParameter } from '../../src/editor/starting-step.ts';
import type { StepChange } from '../../src/editor/steps.ts';
import { startingValues } from '../../src/inputs/starting-values.ts';
import { blankMap, onSphere, type SphereMap } from '../../src/inputs/styles/captures.ts';
import { captureFile } from '../../src/inputs/styles/exact-capture.ts';
import { lookup } from '../../src/inputs/styles/gauss-lookup.ts';
import { add, row, scale, unit, type Vec3 } from '../../src/mesh/vectors.ts';
import { findMethod, methods } from '../../src/methods/registry.ts';
import type { GaussMap } from '../../src/methods/values/gauss-map.ts';
import { type BrushTip, Coverage, Stroke } from '../../src/painting/index.ts';
import { BrushSurface } from '../../src/viewer/brush-surface.ts';
import { canTake } from '../app/offered-methods.ts';
import type { PageStore } from '../app/page-state.ts';
import { paintedName } from '../app/style-gallery.ts';

/** What a press on the ball does: puts the brush's direction there, goes back to none, or takes the direction that is there. */
export type NormalBrushMode = 'paint' | 'erase' | 'pick';

/** What the brush is like. */
export interface Brush {
  readonly mode: NormalBrushMode;
  /** The size of its tip on the ball, in degrees. */
  readonly size: number;
  readonly hardness: number;
  /** The normal that it paints, unit, in the file's axes. */
  readonly direction: Vec3;
  /** The far side gets the mirror image, so that a picture of the front holds all of it. */
  readonly mirror: boolean;
}

/** Paints normals on a ball; the mesh follows every stroke, and each stroke is one entry for undo. */
export class NormalPainter {
  brush: Brush = { mode: 'paint', size: 28, hardness: 0.4, direction: [0, 1, 0], mirror: true };
  readonly #store: PageStore;
  readonly #editor: Editor;
  readonly #soon: (run: () => void) => void;
  #ball: BrushSurface | null = null;
  #stroke: {
    path: Stroke;
    coverage: Coverage<Vec3>;
    mirrored: Coverage<Vec3>;
    base: SphereMap;
    map: SphereMap;
  } | null = null;
  #isScheduled = false;

  /** @param soon runs something before the next picture */
  constructor(store: PageStore, editor: Editor, soon: (run: () => void) => void) {
    this.#store = store;
    this.#editor = editor;
    this.#soon = soon;
  }

  /** What is on the ball: the stroke that is being painted, else the active step's style. */
  get map(): SphereMap {
    return this.#stroke?.map ?? sphereOf(this.#style());
  }

  /** What recipes call the ball of the active step; the balls of other steps keep theirs. */
  get name(): string {
    const { project } = this.#store.state;
    const others = project?.steps.filter(({ id }) => id !== project.active) ?? [];
    const isTaken = (name: string) =>
      others.some(({ parameters, remembered }) =>
        [parameters, ...Object.values(remembered)].some((values) => Object.values(values).includes(name)),
      );
    return freeName(paintedName, isTaken);
  }

  get isPainting(): boolean {
    return this.#stroke !== null;
  }

  toggle(): void {
    const { gallery } = this.#store.state;
    this.#store.set({ gallery: { ...gallery, painting: !gallery.painting } });
  }

  setBrush(change: Partial<Brush>): void {
    this.brush = { ...this.brush, ...change };
    this.#store.set({});
  }

  /** Puts the brush on a point of the unit ball. The pipette takes what is there, and the brush paints with it from then on. */
  begin(point: Vec3): void {
    const base = this.map;
    if (this.brush.mode === 'pick') {
      this.setBrush({ mode: 'paint', direction: unit(lookup(base)(unit(point))) });
      return;
    }
    this.#ball ??= new BrushSurface(base.points, base.triangles);
    const { vertices, around } = this.#ball;
    this.#stroke = {
      path: new Stroke(this.#tip().radius / 4),
      coverage: new Coverage(vertices, around),
      mirrored: new Coverage(vertices, around),
      base,
      map: base,
    };
    this.move(point);
  }

  move(point: Vec3): void {
    const stroke = this.#stroke;
    if (!stroke) return;
    const normals = stroke.map.normals.slice();
    const { mode, mirror } = this.brush;
    const direction = mode === 'erase' ? null : this.brush.direction;
    for (const touch of stroke.path.to(point)) {
      this.#lay(stroke.coverage, unit(touch), direction, normals);
      if (mirror)
        this.#lay(stroke.mirrored, mirrorOf(unit(touch)), direction && mirrorOf(direction), normals);
    }
    stroke.map = { ...stroke.map, normals };
    this.#follow();
  }

  end(): void {
    const stroke = this.#stroke;
    if (!stroke) return;
    this.#stroke = null;
    this.#editor.commit(this.#change(stroke.map), this.brush.mode === 'erase' ? 'Erase' : 'Stroke');
  }

  /** An empty ball: every normal stays as it is. */
  clear(): void {
    this.#editor.restyle(this.#change(blankMap()), 'Clear the ball');
  }

  /** The ball as a file: a picture of its front that holds all of it. */
  capture(): Uint8Array<ArrayBuffer> {
    return captureFile(this.map);
  }

  #tip(): BrushTip {
    return { radius: 2 * Math.sin((this.brush.size * Math.PI) / 360), hardness: this.brush.hardness };
  }

  /** @param direction null: each point's own, which leaves the mesh as it is there */
  #lay(coverage: Coverage<Vec3>, point: Vec3, direction: Vec3 | null, normals: Float64Array): void {
    const { base } = this.#stroke!;
    for (const vertex of coverage.touch(point, this.#tip())) {
      const share = coverage.share[vertex]!;
      const wanted = direction ?? row(base.points, vertex);
      const mixed = unit(add(scale(row(base.normals, vertex), 1 - share), scale(wanted, share)));
      // Between opposite normals there is no middle.
      if (mixed.some((value) => value !== 0)) normals.set(mixed, 3 * vertex);
    }
  }

  /** At most one preview per picture: strokes come faster than screens. */
  #follow(): void {
    if (this.#isScheduled) return;
    this.#isScheduled = true;
    this.#soon(() => {
      this.#isScheduled = false;
      if (this.#stroke) this.#editor.preview(this.#change(this.#stroke.map));
    });
  }

  /** The Gauss map that the active step has, painted or not; null while it is not known. */
  #style(): GaussMap | null {
    const { project } = this.#store.state;
    const step = project && activeStep(project);
    const parameter = styleParameter(findMethod(step?.method ?? ''));
    if (!project || !step || !parameter) return null;
    const asset = project.assets.get(String(step.parameters[parameter.name]));
    if (asset?.kind === 'gauss-map') return asset.map;
    const resolved = step.result?.of.method === step.method && step.result.resolved[parameter.name];
    return (resolved || null) as GaussMap | null;
  }

  #change(map: SphereMap): StepChange {
    const method = methods.find((one) => canTake(one, map))!;
    const parameter = styleParameter(method)!.name;
    const { name } = this;
    const { project } = this.#store.state;
    const step = project && activeStep(project);
    const present = step && (step.method === method.id ? step.parameters : step.remembered[method.id]);
    const starting = () => startingValues(method, { ...project!, style: map, pattern: null });
    return {
      method: method.id,
      parameters: { ...(present ?? (project ? starting() : {})), [parameter]: name },
      assets: new Map([[name, { kind: 'gauss-map', map }]]),
    };
  }
}

const spheres = new WeakMap<GaussMap, SphereMap>();
let blank: SphereMap | null = null;

function sphereOf(style: GaussMap | null): SphereMap {
  if (!style) {
    blank ??= blankMap();
    return blank;
  }
  const known = spheres.get(style) ?? onSphere(style);
  spheres.set(style, known);
  return known;
}

function mirrorOf([x, y, z]: Vec3): Vec3 {
  return [x, y, -z];
}
