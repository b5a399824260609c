/** The Emscripten module; typed where it is loaded, in `wasm-module.ts`. */
declare module '*/whittle-core.mjs' {
  const create: (options: { wasmBinary?: Uint8Array }) => Promise<never>;
  export default create;
}
