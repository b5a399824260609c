import { analogy } from './analogy.ts';
import { arap } from './arap.ts';
import { cubic } from './cubic.ts';
import type { MethodDescriptor } from './descriptor.ts';
import { developable } from './developable.ts';
import { normalmap } from './normalmap.ts';
import { plastic } from './plastic.ts';
import { polycube } from './polycube.ts';
import { reshape } from './reshape.ts';
import { spherical } from './spherical.ts';

/** All methods, in the order in which the page offers them. A contract test holds it against the core's own list. */
export const methods: readonly MethodDescriptor[] = [
  cubic,
  analogy,
  polycube,
  developable,
  normalmap,
  reshape,
  plastic,
  arap,
  spherical,
];

export function findMethod(id: string): MethodDescriptor | undefined {
  return methods.find((method) => method.id === id);
}
