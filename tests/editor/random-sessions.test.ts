import fc from 'fast-check';
import { expect, test } from 'vitest';
import { keptBytes } from '../../src/editor/kept-bytes.ts';
import {
  activeStep,
  firstUnsettled,
  meshAt,
  type Project,
  restShapeOf,
  shownPositions,
} from '../../src/editor/project.ts';
import { tetrahedron } from '../fixtures/fake-engine.ts';
import { headlessEditor, quiet } from '../fixtures/headless-editor.ts';

/**
 * People do anything at any time. Whatever they did, once everything has come to rest the project, its history, the screen and what
 * the worker holds have to agree. The fake engine makes everything 1 + λ times as large, so that a stack multiplies.
 */

const place = fc.nat(4);
const lambda = fc.constantFrom(0, 0.25, 0.5, 1, 3);
const methodId = fc.constantFrom('cubic', 'analogy', 'polycube', 'developable');

/** What changes the stack, each with what it needs to be told. */
const changes = [
  fc.record({ do: fc.constant('add'), id: methodId, lambda }),
  fc.record({ do: fc.constant('remove'), place }),
  fc.record({ do: fc.constant('move'), place, to: place }),
  fc.record({ do: fc.constant('switch'), place, isOn: fc.boolean() }),
  fc.record({ do: fc.constant('activate'), place }),
  fc.record({ do: fc.constant('commit'), lambda }),
  fc.record({ do: fc.constant('drag'), lambda }),
  fc.record({ do: fc.constant('choose'), id: methodId }),
  fc.record({ do: fc.constant('open'), isGood: fc.boolean() }),
  fc.record({ do: fc.constant('reset') }),
  fc.record({ do: fc.constant('export') }),
  fc.record({ do: fc.constant('death') }),
] as const;

/** What leaves a shape that is not yet, or not any more, what the recipe makes. */
const halts = [
  fc.record({ do: fc.constant('preview'), lambda }),
  fc.record({ do: fc.constant('undo') }),
  fc.record({ do: fc.constant('redo') }),
  fc.record({ do: fc.constant('cancel') }),
] as const;

const change = fc.oneof(...changes);
const anything = fc.oneof(change, ...halts);
type Act = typeof anything extends fc.Arbitrary<infer One> ? One : never;

/** Acts, each with how many turns of the event loop pass after it: none, some, or all that it takes. */
const session = <T>(act: fc.Arbitrary<T>) =>
  fc.array(fc.tuple(act, fc.constantFrom(0, 0, 1, 2, 5, 'rest' as const)), { maxLength: 14 });

async function desk() {
  const parts = headlessEditor({ pause: () => new Promise((go) => setTimeout(go, 0)) });
  const { editor, store } = parts;
  const steps = [0.5, 1, 3].map((value) => ({ method: 'cubic', parameters: { lambda: value } }));
  await editor.open(Uint8Array.of(1), 'a.obj', { recipe: { steps } });
  await quiet(store);
  return { ...parts, first: editor.project! };
}

type Desk = Awaited<ReturnType<typeof desk>>;

function carryOut({ editor, engine }: Desk, act: Act): unknown {
  const id = (at: number) => editor.project!.steps[at % editor.project!.steps.length]!.id;
  const values = (value: number) => ({
    parameters: { ...activeStep(editor.project!).parameters, lambda: value },
  });
  switch (act.do) {
    case 'add':
      return editor.addStep(act.id, { lambda: act.lambda });
    case 'remove':
      return editor.removeStep(id(act.place));
    case 'move':
      return editor.moveStep(id(act.place), act.to);
    case 'switch':
      return editor.switchStep(id(act.place), act.isOn);
    case 'activate':
      return editor.activate(id(act.place));
    case 'preview':
      return editor.preview(values(act.lambda));
    case 'commit':
      return editor.commit(values(act.lambda), 'Strength');
    case 'drag':
      editor.preview(values(0.125));
      editor.preview(values(act.lambda));
      return editor.commit(values(act.lambda), 'Strength');
    case 'choose':
      return editor.chooseMethod(act.id);
    case 'open':
      return editor.open(Uint8Array.of(1), act.isGood ? 'b.obj' : 'broken.obj');
    case 'reset':
      return editor.reset();
    case 'export':
      return editor.write('obj');
    case 'death':
      engine.deaths = 1;
      return;
    case 'undo':
      return editor.undo();
    case 'redo':
      return editor.redo();
    case 'cancel':
      return editor.cancel();
  }
}

async function live(desk: Desk, acts: readonly (readonly [Act, number | 'rest'])[]): Promise<void> {
  const { store } = desk;
  for (const [act, turns] of acts) {
    carryOut(desk, act);
    if (turns === 'rest') await quiet(desk.store);
    else for (let k = 0; k < turns; k++) await new Promise((go) => setTimeout(go, 0));
  }
  await quiet(desk.store);
  // A worker that died twice under the same run leaves a way to try again.
  store.state.notice?.action?.run();
  await quiet(desk.store);
}

/** What a run of the recipe makes of the file. */
const fresh = ({ steps }: Project) =>
  steps
    .filter(({ isOn }) => isOn)
    .reduce(
      (shape, { parameters }) => shape.map((x) => x * (1 + (parameters.lambda as number))),
      tetrahedron().positions as Float64Array,
    );

function expectAgreement({ store, canvas, engine }: Desk): void {
  const { history } = store.state;
  const project = store.state.project!;
  const entries = [...history.past, ...history.future];
  expect(project.steps.map(({ id }) => id)).toContain(project.active);
  expect(new Set(project.steps.map(({ id }) => id)).size).toBe(project.steps.length);
  expect(canvas.last).toEqual(shownPositions(project));
  for (const [k, { before }] of entries.entries()) {
    if (k > 0) expect(before).toBe(entries[k - 1]!.after);
  }
  for (const { steps } of [project, ...entries.flatMap(({ before, after }) => [before, after])]) {
    for (const { result } of steps) {
      if (result?.state !== 'settled') continue;
      const { from, parameters } = result.of;
      expect(result.positions).toEqual(from.map((x) => x * (1 + (parameters.lambda as number))));
    }
  }
  expect(keptBytes(entries)).toBeLessThanOrEqual(256 * 2 ** 20);
  const edited = restShapeOf(project, project.active) ?? project.mesh.positions;
  for (const mesh of engine.held) expect([project.mesh, meshAt(project, edited)]).toContain(mesh);
}

test('changes of any kind and in any order end in what the recipe makes', async () => {
  await fc.assert(
    fc.asyncProperty(session(change), async (acts) => {
      const parts = await desk();
      await live(parts, acts);
      expectAgreement(parts);
      const project = parts.editor.project!;
      expect(firstUnsettled(project)).toBeUndefined();
      expect(shownPositions(project)).toEqual(fresh(project));
    }),
    { seed: 11, numRuns: 50 },
  );
});

test('whatever was previewed, stopped or undone, a saved file has what the recipe makes', async () => {
  await fc.assert(
    fc.asyncProperty(session(anything), async (acts) => {
      const parts = await desk();
      await live(parts, acts);
      expectAgreement(parts);
      parts.engine.deaths = 0;
      const written = await parts.editor.write('obj');
      expect(firstUnsettled(written!.project)).toBeUndefined();
      const isStopped = written!.project.steps.some(({ result }) => result?.state === 'stopped');
      if (!isStopped) expect(shownPositions(written!.project)).toEqual(fresh(written!.project));
    }),
    { seed: 11, numRuns: 50 },
  );
});

test('undo solves nothing and leads back to the first project', async () => {
  await fc.assert(
    fc.asyncProperty(session(anything), async (acts) => {
      const parts = await desk();
      const { editor, engine, store, first } = parts;
      await live(parts, acts);
      engine.calls.length = 0;
      while (editor.undo());
      await quiet(store);
      expect(engine.calls).toEqual([]);
      const bare = ({ steps, mesh }: Project) => ({
        mesh,
        steps: steps.map(({ id, method, parameters, isOn }) => ({ id, method, parameters, isOn })),
      });
      expect(bare(editor.project!)).toEqual(bare(first));
      expectAgreement(parts);
    }),
    { seed: 11, numRuns: 50 },
  );
});
