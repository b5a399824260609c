import { describe, expect, it } from 'vitest';
import { measuredOf } from '../../src/editor/measured.ts';
import { activeStep } from '../../src/editor/project.ts';
import { withStep } from '../../src/editor/steps.ts';
import { writePng } from '../../src/inputs/images/png.ts';
import { pixelsOfMap, sphereMap } from '../../src/inputs/styles/captures.ts';
import { measure } from '../../src/measures/index.ts';
import { unit } from '../../src/mesh/vectors.ts';
import { startingRegularizer, startingStrength } from '../../src/methods/starting-lambda.ts';
import type { GaussMap } from '../../src/methods/values/gauss-map.ts';
import { command } from '../../web/app/export.ts';
import { StyleActions } from '../../web/app/style-actions.ts';
import { stepInGrid } from '../../web/panels/grid-steps.ts';
import { tetrahedron } from '../fixtures/fake-engine.ts';
import { headlessEditor, look, quiet } from '../fixtures/headless-editor.ts';

async function desk() {
  const parts = headlessEditor();
  const { engine, store, editor } = parts;
  const styles = new StyleActions({ store, editor, engine, drawn: async () => {} });
  await editor.open(Uint8Array.of(1), 'a.obj');
  const entry = (source: string) => store.state.gallery.entries.find((one) => one.source === source)!;
  const set = (change: object, label: string) =>
    editor.commit({ parameters: { ...activeStep(editor.project!).parameters, ...change } }, label);
  return { ...parts, styles, entry, set };
}

const faceted: GaussMap = { kind: 'closest', normals: Float64Array.of(0, 0, 1) };
const smooth = sphereMap((normal) => normal);

describe('choosing a style', () => {
  it('switches the method, carves from rest and is one entry', async () => {
    const { store, editor, styles, entry, engine } = await desk();
    engine.calls.length = 0;
    await styles.choose(entry('icosahedron'));
    await quiet(store);
    const { method, parameters, result } = look(editor.project);
    expect([method, parameters.style, result!.state]).toEqual(['analogy', 'icosahedron', 'settled']);
    expect(parameters.lambda).toBe(startingStrength(faceted));
    expect(engine.calls).toEqual([`solve rest ${parameters.lambda}`]);
    expect(store.state.history.past.map(({ label }) => label)).toEqual(['Icosahedron']);
    editor.undo();
    expect(look(editor.project).method).toBe('cubic');
  });

  it('starts a coarse mesh in flat faces with farap, all else with arap, unless one was chosen', async () => {
    const { editor, styles, entry, set } = await desk();
    const regularizer = () => look(editor.project).parameters.regularizer;
    await styles.choose(entry('cube'));
    expect(regularizer()).toBe('farap');
    await styles.choose(entry('terraced'));
    expect(regularizer()).toBe('arap');
    set({ regularizer: 'acap' }, 'Edges');
    await styles.choose(entry('cube'));
    expect(regularizer()).toBe('acap');
    expect(startingRegularizer({ typicalPart: 1800 }, faceted)).toBe('arap');
    expect(startingRegularizer({ typicalPart: 600 }, faceted)).toBe('farap');
  });

  it('stays on when another mesh is opened', async () => {
    const { store, editor, styles, entry, engine } = await desk();
    await styles.choose(entry('icosahedron'));
    await quiet(store);
    const { parameters } = look(editor.project);
    engine.calls.length = 0;
    await editor.open(Uint8Array.of(2), 'b.obj');
    await quiet(store);
    expect(look(editor.project)).toMatchObject({ method: 'analogy', parameters });
    expect(parameters.style).toBe('icosahedron');
    expect(engine.calls).toContain(`solve rest ${parameters.lambda}`);
  });

  it('keeps a strength that was chosen by hand and follows the style otherwise', async () => {
    const { store, editor, styles, entry, set } = await desk();
    await styles.choose(entry('cube'));
    await styles.choose(entry('terraced'));
    expect(look(editor.project).parameters.lambda).toBe(startingStrength(smooth));
    set({ lambda: 1.7 }, 'Strength');
    await styles.choose(entry('cube'));
    await quiet(store);
    expect(look(editor.project).parameters.lambda).toBe(1.7);
  });

  it('remembers the style while another method is on', async () => {
    const { store, editor, styles, entry } = await desk();
    await styles.choose(entry('cylinder'));
    await styles.chooseMethod('cubic');
    await styles.chooseMethod('analogy');
    await quiet(store);
    expect(look(editor.project).parameters.style).toBe('cylinder');
    expect(command(editor.project!).text).toContain('--style cylinder --lambda 4');
  });
});

describe('choosing directions', () => {
  it('opens with the cube, and each method keeps what it has', async () => {
    const { store, editor, styles, entry, set } = await desk();
    await styles.choose(entry('terraced'));
    await styles.chooseMethod('polycube');
    await quiet(store);
    expect(look(editor.project)).toMatchObject({
      method: 'polycube',
      parameters: { lambda: 1, smoothing: 0.2, directions: 'cube' },
    });
    expect(styles.chosenId).toBe('shapes-cube');
    set({ lambda: 0.5 }, 'Pace');
    await styles.choose(entry('octahedron'));
    expect(look(editor.project)).toMatchObject({ method: 'polycube', parameters: { lambda: 0.5 } });
    expect(command(editor.project!).text).toContain('polycube a.obj --directions octahedron --lambda 0.5');
    await styles.chooseMethod('analogy');
    expect(styles.chosenId).toBe('captures-terraced');
    await styles.chooseMethod('polycube');
    expect(styles.chosenId).toBe('shapes-octahedron');
    await quiet(store);
  });

  it('leaves to the styles what has no few directions', async () => {
    const { store, editor, styles, entry } = await desk();
    await styles.chooseMethod('polycube');
    await styles.choose(entry('terraced'));
    await quiet(store);
    expect(look(editor.project)).toMatchObject({ method: 'analogy', parameters: { style: 'terraced' } });
  });

  it('measures the angle to the direction that is the closest now', async () => {
    const { store, editor, styles } = await desk();
    await styles.chooseMethod('polycube');
    await quiet(store);
    const project = editor.project!;
    // A quarter turn: every normal has left its first direction and found another.
    const positions = project.mesh.positions.slice();
    for (let p = 0; p < positions.length; p += 3)
      positions.set([-project.mesh.positions[p + 1]!, project.mesh.positions[p]!], p);
    const step = activeStep(project);
    const turned = measuredOf(withStep(project, { ...step, result: { ...step.result!, positions } }));
    const [before, after] = [measure(turned, 'angle-before')!, measure(turned, 'angle-after')!];
    for (const [p, value] of after.values.entries()) expect(value).toBeCloseTo(before.values[p]!, 2);
  });
});

describe('bringing a style', () => {
  const tilted = sphereMap(([x, y, z]) => unit([x, y + 0.5, z]));

  it('takes a PNG as a capture and puts it on', async () => {
    const { store, editor, styles } = await desk();
    await styles.add(writePng(pixelsOfMap(tilted, 64)), 'tilted.png');
    await quiet(store);
    expect(look(editor.project).parameters.style).toBe('tilted.png');
    expect(store.state.gallery.entries.at(-1)).toMatchObject({ group: 'captures', name: 'tilted' });
  });

  it('takes a convex mesh by its faces', async () => {
    const { store, editor, styles } = await desk();
    await styles.add(Uint8Array.of(1), 'own.obj');
    await quiet(store);
    expect(look(editor.project).result!.resolved.style).toMatchObject({ kind: 'closest' });
  });

  it('refuses a picture that is no capture, and keeps all as it was', async () => {
    const { store, editor, styles } = await desk();
    const before = editor.project;
    const grey = { width: 32, height: 32, data: new Uint8Array(4 * 32 * 32).fill(128) };
    await styles.add(writePng(grey), 'photo.png');
    expect(store.state.notice).toMatchObject({ tone: 'error' });
    expect(editor.project).toBe(before);
  });

  it('asks before it reads a concave mesh through the sphere, and says why it cannot', async () => {
    const { store, editor, styles, engine, entry } = await desk();
    const dented = tetrahedron();
    dented.triangles.set([1, 2, 3], 0);
    const { positions } = dented;
    const concave = {
      positions: Float64Array.of(...positions, 0.1, 0.1, 0.1),
      triangles: Uint32Array.of(0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 4, 2, 3, 4, 3, 1, 4),
    };
    engine.read = async () => ({ mesh: concave, format: 'obj', warnings: [] });
    await styles.add(Uint8Array.of(1), 'dented.obj');
    expect(store.state.gallery.offer!.why).toContain('dented.obj');
    await styles.accept();
    // The fake engine lets nothing flow to a sphere.
    expect(store.state.notice!.text).toContain('did not flow to a sphere');
    expect(store.state.gallery).toMatchObject({ pending: null, flow: null });
    expect(look(editor.project).method).toBe('cubic');
    expect(entry('dented.obj')).toBeUndefined();
  });
});

describe('walking in the grid', () => {
  const boxes = [0, 1, 2, 3, 4, 5, 6].map((k) => ({ left: 50 * (k % 3), top: 40 * Math.floor(k / 3) }));

  it.each([
    [0, 'ArrowRight', 1],
    [2, 'ArrowRight', 3],
    [1, 'ArrowDown', 4],
    [5, 'ArrowDown', 6],
    [6, 'ArrowUp', 3],
    [0, 'ArrowUp', 0],
    [3, 'Home', 0],
    [0, 'End', 6],
    [0, 'Tab', null],
    [-1, 'ArrowDown', null],
  ])('from %i by %s to %s', (here, key, to) => {
    expect(stepInGrid(boxes, here, key)).toBe(to);
  });

  it('goes sideways with every arrow in a single row', () => {
    const row = boxes.map((_, k) => ({ left: 50 * k, top: 0 }));
    expect(stepInGrid(row, 2, 'ArrowDown')).toBe(3);
    expect(stepInGrid(row, 2, 'ArrowUp')).toBe(1);
  });
});
