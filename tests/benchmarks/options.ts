/** Methods that have a plain path to stand beside. */
export const comparedMethods = ['cubic', 'analogy', 'arap'] as const;
export type ComparedMethod = (typeof comparedMethods)[number];

/** Methods that go through the same loop or solver with other targets, timed alone. */
export const timedMethods = ['normalmap', 'developable', 'polycube'] as const;
export type TimedMethod = (typeof timedMethods)[number];

/** Methods that the benchmark knows a problem for; reshaping has shapes and sizes of its own. */
export const methods = [...comparedMethods, ...timedMethods, 'reshape'] as const;
export type MethodId = (typeof methods)[number];

export const isCompared = (method: MethodId): method is ComparedMethod =>
  comparedMethods.some((name) => name === method);

/** Vertices of its meshes: the bunny has 22046, the others are icospheres. */
export const sizes = [2562, 10242, 22046, 40962, 163842] as const;
export type Size = (typeof sizes)[number];

/** About how many faces the shapes have that are reshaped. */
export const faceCounts = [2000, 8500, 22000, 84000] as const;
export type FaceCount = (typeof faceCounts)[number];

export interface Options {
  readonly methods: readonly MethodId[];
  readonly sizes: readonly Size[];
  readonly faceCounts: readonly FaceCount[];
  /** Whether the tables go to `docs/benchmarks.md` as well. */
  readonly write: boolean;
  /** A git reference to time the working tree against. */
  readonly against?: string;
}

export const usage = `usage: npm run bench -- [METHOD …] [SIZE …] [--quick] [--write] [--against REF]
  METHOD    ${methods.join(', ')}; all unless one is named
  SIZE      vertices: ${sizes.join(', ')}; all unless one is named;
            for reshape about so many faces: ${faceCounts.join(', ')}; likewise
  --quick   2562 and 22046 vertices only, up to 22000 faces
  --write   keeps the tables in docs/benchmarks.md
  --against times the working tree's wasm module against that of a commit or branch, 2562 and 22046 vertices by default
   or: npm run bench -- angles [--write]   how near ten meshes come to eight primitives`;

const quickSizes: readonly Size[] = [2562, 22046];
const quickFaceCounts = faceCounts.filter((count) => count <= 22000);

/** @throws Error, with the usage, for what it does not know */
export function parseOptions(args: readonly string[]): Options {
  const chosenMethods: MethodId[] = [];
  const chosenSizes: Size[] = [];
  const chosenFaceCounts: FaceCount[] = [];
  let quick = false;
  let write = false;
  let against: string | undefined;
  for (let i = 0; i < args.length; i++) {
    const word = args[i]!;
    const method = methods.find((name) => name === word);
    const size = sizes.find((vertices) => String(vertices) === word);
    const faces = faceCounts.find((count) => String(count) === word);
    if (method) chosenMethods.push(method);
    else if (size) chosenSizes.push(size);
    else if (faces) chosenFaceCounts.push(faces);
    else if (word === '--quick') quick = true;
    else if (word === '--write') write = true;
    else if (word === '--against' && args[i + 1]) against = args[++i];
    else throw new Error(`“${word}” is not known here.\n${usage}`);
  }
  if (write && against) throw new Error(`--write keeps tables of the reference, not of --against.\n${usage}`);
  const fallback = quick || against ? quickSizes : sizes;
  const all = against ? comparedMethods : methods;
  if (against && !chosenMethods.every(isCompared))
    throw new Error(`--against knows ${comparedMethods.join(', ')} only.\n${usage}`);
  return {
    methods: chosenMethods.length > 0 ? chosenMethods : all,
    sizes: chosenSizes.length > 0 ? chosenSizes : fallback,
    faceCounts: chosenFaceCounts.length > 0 ? chosenFaceCounts : quick ? quickFaceCounts : faceCounts,
    write,
    ...(against ? { against } : {}),
  };
}
