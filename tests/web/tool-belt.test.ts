import { describe, expect, it } from 'vitest';
import type { Interaction } from '../../src/viewer/interaction.ts';
import type { ShapeChange } from '../../src/viewer/viewer.ts';
import { Mirror } from '../../web/app/mirrors.ts';
import { newPageStore } from '../../web/app/page-state.ts';
import { ToolBelt } from '../../web/app/tool-belt.ts';
import type { Tools } from '../../web/tools/all.ts';
import { tetrahedron } from '../fixtures/fake-engine.ts';

/** A belt with one tool that writes down what happens to it. */
function belt() {
  const said: string[] = [];
  const tool = { enter: () => said.push('enter'), leave: () => said.push('leave') };
  let tell: (change: ShapeChange) => void = () => {};
  const interaction = {
    viewer: {
      onShape: (listener: (change: ShapeChange) => void) => {
        tell = listener;
      },
    },
    picking: { isReady: true, ready: () => Promise.resolve() },
    setTool: () => {},
    cancel: () => said.push('cancel'),
  };
  const tools = new ToolBelt(
    newPageStore(),
    interaction as unknown as Interaction,
    { move: tool } as unknown as Tools,
  );
  return { tools, said, tell: (change: ShapeChange) => tell(change) };
}

describe('the tool in the hand', () => {
  it('begins anew on another mesh, whose coming takes all layers away, and not with every frame', () => {
    const { tools, said, tell } = belt();
    tools.choose('move');
    tell('positions');
    expect(said).toEqual(['enter']);
    tell('mesh');
    expect(said).toEqual(['enter', 'cancel', 'leave', 'enter']);
  });
});

describe('a mirror', () => {
  it('is the one of its mesh, and of no other that comes after it', async () => {
    const mirror = new Mirror();
    const [first, second] = [tetrahedron(), tetrahedron()];
    const found = (mesh: typeof first) => new Promise<void>((done) => mirror.of(mesh, done));
    await found(first);
    const map = mirror.of(first, () => {});
    expect(map!.partner).toHaveLength(4);
    const other = found(second);
    expect(mirror.of(second, () => {})).toBeNull();
    await other;
    expect(mirror.of(second, () => {})!.partner).toHaveLength(4);
    expect(mirror.of(second, () => {})).not.toBe(map);
  });
});
