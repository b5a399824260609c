import { BackSide, DoubleSide, FrontSide, LineBasicMaterial, MeshStandardMaterial } from 'three';
import type { StageTheme } from './stage.ts';
import type { Surface } from './surface.ts';

const casting = { out: BackSide, in: FrontSide, neither: DoubleSide } as const;

/** What bodies look as if made of: clay, smooth or by its faces, and ink for their wires. */
export class Finish {
  readonly clay = new MeshStandardMaterial({ roughness: 0.62, side: DoubleSide });
  readonly facets = this.clay.clone();
  readonly ink = new LineBasicMaterial({ transparent: true, depthWrite: false });

  constructor() {
    for (const material of [this.clay, this.facets]) {
      material.polygonOffset = true;
      material.polygonOffsetFactor = material.polygonOffsetUnits = 1;
    }
    this.facets.flatShading = true;
  }

  /** @param isPainted the body has colours of its own, of its file or others */
  paint(theme: StageTheme, isPainted: boolean): void {
    for (const material of [this.clay, this.facets]) {
      if (material.vertexColors !== isPainted) material.needsUpdate = true;
      material.vertexColors = isPainted;
      material.color.set(isPainted ? '#ffffff' : theme.clay);
    }
    this.ink.color.set(theme.wire);
    this.ink.opacity = theme.wireOpacity;
  }

  /** What casts is the side away from the light, which is dark anyway: no speckle where it grazes. A sheet has no such side. */
  face(facing: Surface['facing']): void {
    for (const material of [this.clay, this.facets]) material.shadowSide = casting[facing];
  }

  dispose(): void {
    for (const material of [this.clay, this.facets, this.ink]) material.dispose();
  }
}
