import type { Weld } from '../mesh/mesh.ts';
import { findMethod } from '../methods/registry.ts';
import { strengthParameter } from '../methods/set-by-hand.ts';
import type { ParameterValues } from '../methods/values/index.ts';
import type { Scalars } from '../methods/values/scalars.ts';
import type { RecipeStep } from '../recipe/index.ts';

/**
 * Strength as it is painted: what share of the step's λ each welded vertex has, 0 to 1. A step keeps λ itself of every position; the
 * shares are remembered beside that, so that they outlast a λ of 0.
 */
const remembered = new WeakMap<object, { readonly lambda: number; readonly shares: Float64Array }>();

/** The shares (#V) that a step was given; null where nobody has painted. */
export function sharesOf(step: RecipeStep, { positionOfVertex }: Weld): Float64Array | null {
  const own = painted(step);
  if (!own) return null;
  const lambda = lambdaOf(step);
  const known = remembered.get(own);
  if (known?.lambda === lambda) return known.shares;
  const shares = Float64Array.from(positionOfVertex, (position) => {
    const value = own[position] ?? 0;
    return lambda > 0 ? Math.min(1, value / lambda) : Math.min(1, value);
  });
  remembered.set(own, { lambda, shares });
  return shares;
}

/** The step's values with these shares (#V), which the caller leaves as they are; null takes them away. */
export function withShares(step: RecipeStep, shares: Float64Array | null, weld: Weld): ParameterValues {
  const name = strengthParameter(findMethod(step.method));
  if (name === undefined) return step.parameters;
  const { [name]: _, ...others } = step.parameters;
  if (!shares) return others;
  const lambda = lambdaOf(step);
  const { vertexOfPosition } = weld;
  const own = new Float64Array(vertexOfPosition.length);
  for (let position = 0; position < own.length; position++)
    own[position] = lambda * shares[vertexOfPosition[position]!]!;
  remembered.set(own, { lambda, shares });
  return { ...others, [name]: own };
}

/** Values whose λ was changed, with what was painted changed along. */
export function withPaintedStrength(step: RecipeStep, values: ParameterValues, weld: Weld): ParameterValues {
  const next = { method: step.method, parameters: values };
  if (!painted(step) || lambdaOf(step) === lambdaOf(next)) return values;
  return withShares(next, sharesOf(step, weld), weld);
}

function painted({ method, parameters }: RecipeStep): Scalars | null {
  const name = strengthParameter(findMethod(method));
  const own = name === undefined ? undefined : (parameters[name] as Scalars | undefined);
  return own && own.length > 0 ? own : null;
}

/** λ of the whole step. */
function lambdaOf({ method, parameters }: RecipeStep): number {
  const descriptor = findMethod(method)?.parameters.find(({ name }) => name === 'lambda');
  return Number(parameters.lambda ?? (descriptor?.kind === 'number' ? descriptor.default : 1));
}
