/** The Emscripten module; typed where it is loaded, in `wasm-module.ts`. */
declare module '*/whittle-core.mjs' {
  const create: (options: object) => Promise<never>;
  export default create;
}
