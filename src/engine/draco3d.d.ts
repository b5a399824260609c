/** The decoder that Draco's makers compile with Emscripten; the package has no types. This is what is used of it. */
declare module 'draco3d/draco_decoder_nodejs.js' {
  interface DracoModule {
    readonly Decoder: new () => DracoDecoder;
    readonly Mesh: new () => DracoGeometry;
    readonly DracoFloat32Array: new () => DracoArray;
    readonly DracoInt32Array: new () => DracoArray;
    destroy(object: unknown): void;
  }

  interface DracoDecoder {
    DecodeArrayToMesh(bytes: Int8Array, length: number, mesh: DracoGeometry): { ok(): boolean };
    GetAttributeByUniqueId(mesh: DracoGeometry, id: number): DracoAttribute;
    GetAttributeFloatForAllPoints(mesh: DracoGeometry, attribute: DracoAttribute, into: DracoArray): boolean;
    GetAttributeInt32ForAllPoints(mesh: DracoGeometry, attribute: DracoAttribute, into: DracoArray): boolean;
    GetFaceFromMesh(mesh: DracoGeometry, face: number, into: DracoArray): boolean;
  }

  interface DracoGeometry {
    num_points(): number;
    num_faces(): number;
  }

  interface DracoAttribute {
    /** 0 where there is none of that id. */
    readonly ptr: number;
  }

  interface DracoArray {
    size(): number;
    GetValue(index: number): number;
  }

  const createDecoder: (options: { wasmBinary: Uint8Array }) => Promise<DracoModule>;
  export default createDecoder;
  export type { DracoArray, DracoDecoder, DracoGeometry, DracoModule };
}

/** The whole package, of which tests use the encoder. */
declare module 'draco3d';
