import { TreeKeeper, type TreeRequest } from './tree.ts';

/** The thread in which the trees of boxes are made: half a million faces take it half a second, and the page none. */
const keeper = new TreeKeeper();

addEventListener('message', ({ data }: MessageEvent<TreeRequest>) => {
  const answer = keeper.answer(data);
  const { roots, order } = answer.tree;
  postMessage(answer, { transfer: order ? [...roots, order.buffer] : roots });
});
