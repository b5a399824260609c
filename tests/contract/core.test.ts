import { describe, expect, test } from 'vitest';
import type { CoreSession } from '../../src/engine/core-api.ts';
import { WhittleError } from '../../src/mesh/failure.ts';
import { row, scale } from '../../src/mesh/vectors.ts';
import { configure, prepare, testCore } from '../fixtures/core.ts';
import { bunny, bunnyLevel, icosphere, type TestMesh, together } from '../fixtures/meshes.ts';

interface Run {
  positions: Float64Array;
  energy: number[];
  outcome: string;
}

async function open(mesh: TestMesh): Promise<CoreSession> {
  const session = (await testCore()).open();
  session.load(mesh.positions, mesh.triangles);
  return session;
}

async function stylize(mesh: TestMesh, parameters: Record<string, number>): Promise<Run> {
  const session = await open(mesh);
  configure(session, mesh, 'cubic', parameters);
  prepare(session);
  const energy: number[] = [];
  let outcome = 'running';
  while (outcome === 'running') {
    const step = session.step();
    outcome = step.outcome;
    energy.push(step.energy);
  }
  const positions = new Float64Array(mesh.positions.length);
  session.copyPositions(positions);
  session.free();
  return { positions, energy, outcome };
}

/** Area-weighted mean angle of face normals to the nearest axis, degrees. */
function angleToAxes({ positions, triangles }: { positions: Float64Array; triangles: Uint32Array }): number {
  let sum = 0;
  let area = 0;
  const at = (corner: number, axis: number): number => positions[3 * triangles[corner]! + axis]!;
  for (let face = 0; face < triangles.length; face += 3) {
    const a = [0, 1, 2].map((axis) => at(face + 1, axis) - at(face, axis)) as [number, number, number];
    const b = [0, 1, 2].map((axis) => at(face + 2, axis) - at(face, axis)) as [number, number, number];
    const n = [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
    const length = Math.hypot(...n);
    if (length === 0) continue;
    sum += length * Math.acos(Math.min(1, Math.max(...n.map(Math.abs)) / length));
    area += length;
  }
  return ((sum / area) * 180) / Math.PI;
}

describe('cubic on the bunny', () => {
  // Energies of an independent implementation of the paper on the very same meshes, at the paper's own stop.
  test.each([
    [0, 0.2, 0.61241],
    [0, 0.4, 1.17297],
    [1, 0.2, 0.57293],
    [1, 0.4, 1.08965],
    [2, 0.4, 1.04606],
  ])(
    'level %i, λ %f: energy falls to that of other implementations or below',
    async (level, lambda, reference) => {
      const mesh = bunnyLevel(level);
      const run = await stylize(mesh, { lambda });
      expect(run.outcome).toBe('converged');
      const first = run.energy[0]!;
      const last = run.energy.at(-1)!;
      for (let k = 1; k < run.energy.length; k++)
        expect(run.energy[k]!).toBeLessThanOrEqual(run.energy[k - 1]! * (1 + 1e-12));
      expect(last).toBeLessThan(reference + 0.003 * (first - reference));
      expect(last).toBeGreaterThan(reference - 0.06 * (first - reference));
    },
  );

  test('cubeness rises with λ', async () => {
    const mesh = bunny();
    let last = angleToAxes(mesh);
    for (const lambda of [0.1, 0.2, 0.4, 0.8, 1.6]) {
      const { positions } = await stylize(mesh, { lambda });
      const angle = angleToAxes({ positions, triangles: mesh.triangles });
      expect(angle).toBeLessThan(last);
      last = angle;
    }
  });

  test('the same bits twice, whatever ran in between', async () => {
    const mesh = bunny();
    const first = await stylize(mesh, { lambda: 0.4, maxIterations: 30 });
    await stylize(icosphere(2), { lambda: 1 });
    const second = await stylize(mesh, { lambda: 0.4, maxIterations: 30 });
    expect(second.positions).toEqual(first.positions);
    expect(second.energy).toEqual(first.energy);
  });

  test('inches or metres make no difference', async () => {
    const mesh = bunny();
    const plain = await stylize(mesh, { lambda: 0.4, maxIterations: 30 });
    const scaled = { ...mesh, positions: mesh.positions.map((x) => x * 0.0254) };
    const run = await stylize(scaled, { lambda: 0.4, maxIterations: 30 });
    const size = Math.max(...plain.positions);
    for (let i = 0; i < plain.positions.length; i++) {
      expect(Math.abs(run.positions[i]! / 0.0254 - plain.positions[i]!)).toBeLessThan(1e-7 * size);
    }
  });
});

describe('the core’s border', () => {
  test('a hundred thousand parts', async () => {
    const tetrahedron: TestMesh = {
      positions: Float64Array.of(0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1),
      triangles: Uint32Array.of(0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3),
    };
    const copies = Array.from({ length: 100_000 }, (_, i) => ({
      mesh: tetrahedron,
      offset: [2 * (i % 300), 2 * Math.floor(i / 300), 0] as const,
    }));
    const { positions, outcome } = await stylize(together(...copies), { lambda: 0.2, maxIterations: 3 });
    expect(outcome).toMatch(/converged|iteration-limit/);
    expect(positions.every(Number.isFinite)).toBe(true);
    expect(Math.abs(positions[12 * 70_000]! - 2 * (70_000 % 300))).toBeLessThan(1);
  });

  test('refusals carry code, sentence and element', async () => {
    const session = (await testCore()).open();
    const mesh = icosphere(1);
    const triangles = mesh.triangles.slice();
    triangles[7] = 9041;
    const attempt = (): unknown => session.load(mesh.positions, triangles);
    expect(attempt).toThrowError(WhittleError);
    expect(attempt).toThrowError(/face 2 uses vertex 9041/);
    try {
      attempt();
    } catch (error) {
      expect(error).toMatchObject({ code: 'index-out-of-range', element: 2 });
    }
    session.free();
  });

  test('a method refuses what is not for it with its own code', async () => {
    const session = (await testCore()).open();
    const { positions, triangles } = icosphere(2);
    session.load(positions, triangles.slice(3));
    session.configure('spherical', new Map());
    expect(() => prepare(session)).toThrowError(
      /open along 3 edges, the first at vertex \d+; close its holes/,
    );
    expect(() => prepare(session)).toThrowError(expect.objectContaining({ code: 'unsuitable-mesh' }));
    session.free();
  });

  test('memory at 88k vertices stays below 1.5 KB a vertex', async () => {
    const { loadCore } = await import('../../src/engine/core.ts');
    const { readFileSync } = await import('node:fs');
    const core = await loadCore(readFileSync('wasm/dist/whittle-core.wasm'));
    const mesh = bunnyLevel(3);
    const session = core.open();
    session.load(mesh.positions, mesh.triangles);
    session.configure('cubic', new Map());
    prepare(session);
    session.step();
    expect(core.heapBytes() / (mesh.positions.length / 3)).toBeLessThan(1.5 * 1024);
  });

  test('memory of reshaping grows with the mesh and no faster', async () => {
    const { loadCore } = await import('../../src/engine/core.ts');
    const { readFileSync } = await import('node:fs');
    const module = readFileSync('wasm/dist/whittle-core.wasm');
    /** Bytes a face once both systems have been solved. */
    const bytesAFace = async (mesh: TestMesh): Promise<number> => {
      const core = await loadCore(module);
      const session = core.open();
      session.load(mesh.positions, mesh.triangles);
      const [first, last] = [row(mesh.positions, 0), row(mesh.positions, 1)];
      const handles = { vertices: [0, 1], targets: [first, scale(last, 1.3)] };
      configure(session, mesh, 'reshape', { handles });
      prepare(session);
      for (let iterations = 0; iterations < 2; ) if (session.step().outcome !== 'midway') iterations++;
      return core.heapBytes() / (mesh.triangles.length / 3);
    };
    const [some, many] = [await bytesAFace(icosphere(5)), await bytesAFace(icosphere(6))];
    expect(many).toBeLessThan(1.2 * some);
    expect(many).toBeLessThan(8 * 1024);
  });
});
