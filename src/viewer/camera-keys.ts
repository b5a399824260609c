import type { CameraRig } from './camera-rig.ts';

const step = Math.PI / 24;

const keys: Readonly<Record<string, (rig: CameraRig) => void>> = {
  ArrowLeft: (rig) => rig.turn(-step, 0),
  ArrowRight: (rig) => rig.turn(step, 0),
  ArrowUp: (rig) => rig.turn(0, step),
  ArrowDown: (rig) => rig.turn(0, -step),
  '+': (rig) => rig.approach(0.85),
  '=': (rig) => rig.approach(0.85),
  '-': (rig) => rig.approach(1 / 0.85),
};

/** The camera from the keyboard, while the canvas has the focus: arrows go around the object, plus and minus nearer and away. */
export function listenForCameraKeys(
  canvas: HTMLElement,
  rig: CameraRig,
  moved: () => void,
  signal: AbortSignal,
): void {
  const press = (event: KeyboardEvent) => {
    const does = event.ctrlKey || event.metaKey || event.altKey ? undefined : keys[event.key];
    if (!does) return;
    event.preventDefault();
    does(rig);
    moved();
  };
  canvas.addEventListener('keydown', press, { signal });
}
