// Whittle as a library for Node: everything of `index.ts`, with an engine in the very thread that asks for it.

export { createNodeEngine as createEngine } from './engine/in-node.ts';
export * from './index.ts';
