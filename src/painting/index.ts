export { type BrushTip, falloff, Stroke } from './brush.ts';
export type { FieldCanvas } from './canvas.ts';
export { type Around, Coverage } from './coverage.ts';
export { type FieldBrush, type FieldOperation, FieldStroke, unpainted } from './field-stroke.ts';
export { SphereCanvas } from './sphere-canvas.ts';
export { SurfaceCanvas } from './surface-canvas.ts';
