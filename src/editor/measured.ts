import { findPrimitive } from '../inputs/styles/primitives.ts';
import type { Measured, NormalTargets } from '../measures/index.ts';
import { findMethod } from '../methods/registry.ts';
import type { GaussMap } from '../methods/values/gauss-map.ts';
import { activeStep, type Project, type Result, type Step, shownResult } from './project.ts';

/** A project as overlays measure it: the shape on the screen, and what the step that made it draws normals to. */
export function measuredOf(project: Project): Measured {
  const result = shownResult(project);
  const step = project.steps.find((one) => one.result === result && result !== null) ?? activeStep(project);
  return {
    mesh: project.mesh,
    positions: result?.positions ?? null,
    targets: targetsOf(step, result),
    fields: result?.fields ?? [],
    strengths: strengthsOf(step, project.mesh.positions.length / 3),
  };
}

function targetsOf({ method, parameters }: Step, result: Result | null): NormalTargets | null {
  const targets = findMethod(method)?.targets?.(parameters);
  if (!targets) return null;
  const map = mapOf(result?.resolved[targets.style] ?? parameters[targets.style] ?? 'cube');
  const from = targets.lookedUpFrom === 'input' ? (result?.of.from ?? null) : null;
  return map && { map, from };
}

const maps = new Map<string, GaussMap>();

/** A Gauss map as it is; by its name, that of a solid of ours, the same object at every asking. */
function mapOf(style: unknown): GaussMap | null {
  if (typeof style !== 'string') return Array.isArray(style) ? null : (style as GaussMap);
  const solid = findPrimitive(style);
  if (!solid) return null;
  const map = maps.get(style) ?? { kind: 'closest', normals: solid.normals };
  maps.set(style, map);
  return map;
}

/** One number for each position of the file; null where there is only the one λ. */
function strengthsOf({ parameters }: Step, count: number): ArrayLike<number> | null {
  const { lambdaPerVertex: given } = parameters;
  const isList = Array.isArray(given) || given instanceof Float64Array;
  return isList && given.length === count ? (given as ArrayLike<number>) : null;
}
