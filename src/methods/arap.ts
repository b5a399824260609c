import type { MethodDescriptor } from './descriptor.ts';
import { regularizer, shared } from './shared-parameters.ts';

export const arap: MethodDescriptor = {
  id: 'arap',
  title: 'As rigid as possible',
  summary: 'Move handles and let the rest follow with as little stretching as possible.',
  paper: 'Sorkine and Alexa 2007, spokes and rims of Chao et al. 2010',
  shading: 'smooth',
  parameters: [regularizer, ...shared],
};
