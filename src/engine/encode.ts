import type { Weld } from '../mesh/mesh.ts';
import type { MethodDescriptor } from '../methods/descriptor.ts';
import { encodeValue, type ParameterValues } from '../methods/values/index.ts';
import type { Encoded } from '../methods/values/parameter.ts';

/** Values as the core takes them, by parameter name; what is absent has its default there. */
export type EncodedValues = ReadonlyMap<string, Encoded>;

/**
 * Lays checked values out for the core: vertices by their number in the welded mesh.
 *
 * @throws WhittleError `bad-handles`, `bad-planes` or `bad-parameter`, its element the source vertex, for vertices that the mesh has not and for
 *   the mere names of styles and images
 */
export function encodeValues(method: MethodDescriptor, values: ParameterValues, weld: Weld): EncodedValues {
  const encoded = new Map<string, Encoded>();
  for (const descriptor of method.parameters) {
    const value = values[descriptor.name];
    if (value !== undefined && !descriptor.isForLibrary)
      encoded.set(descriptor.name, encodeValue(descriptor, value, weld));
  }
  return encoded;
}
