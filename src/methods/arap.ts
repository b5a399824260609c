import type { MethodDescriptor } from './descriptor.ts';
import { regularizer, shared } from './shared-parameters.ts';

export const arap: MethodDescriptor = {
  id: 'arap',
  title: 'Pose',
  intent: 'move',
  summary:
    'Pose the mesh: hold parts still, pull others, and the rest follows with as little stretching as possible.',
  paper: 'Sorkine and Alexa 2007, spokes and rims of Chao et al. 2010',
  shading: 'smooth',
  parameters: [regularizer, ...shared],
};
