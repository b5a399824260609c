import { type Camera, type Scene, WebGLRenderer } from 'three';

/** What the viewer asks of a renderer; a test gives its own. */
export interface Renderer {
  setPixelRatio(ratio: number): void;
  setSize(width: number, height: number, style: boolean): void;
  render(scene: Scene, camera: Camera): void;
  /** CSS pixels from the lower left corner. */
  setViewport(x: number, y: number, width: number, height: number): void;
  /** CSS pixels from the lower left corner; outside nothing is drawn while {@link setScissorTest} is on. */
  setScissor(x: number, y: number, width: number, height: number): void;
  setScissorTest(isOn: boolean): void;
  /** Gives the graphics context back: browsers have only a few, and collect those that are not given back too late. */
  dispose(): void;
  readonly shadowMap: { enabled: boolean; type: number; autoUpdate: boolean; needsUpdate: boolean };
}

/** @throws Error with a sentence for people when the browser gives no WebGL context */
export function webGlRenderer(canvas: HTMLCanvasElement): WebGLRenderer {
  try {
    const renderer = new WebGLRenderer({ canvas, antialias: true, alpha: true });
    const dispose = renderer.dispose.bind(renderer);
    renderer.dispose = () => {
      dispose();
      renderer.forceContextLoss();
    };
    return renderer;
  } catch {
    throw new Error(
      'This browser cannot draw 3D here (WebGL is off or missing). Turn on hardware acceleration or try another browser; ' +
        'shaping and export still work.',
    );
  }
}
