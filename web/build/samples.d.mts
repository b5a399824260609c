/** Writes the sample meshes to public/samples unless they are there in this version. */
export function makeSamples(options?: { force?: boolean }): Promise<void>;
