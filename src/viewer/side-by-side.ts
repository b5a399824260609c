import type { Mesh } from '../mesh/mesh.ts';
import { Body } from './body.ts';
import { type Box, middleOf } from './box.ts';
import { Finish } from './finish.ts';
import type { Studio, Viewer } from './viewer.ts';

/** Another shape of the mesh, and where it is drawn. */
interface Picture {
  readonly body: Body;
  box: Box;
}

/**
 * Shapes of one mesh side by side on one canvas, from one camera: what turns one turns all. The viewer's own is the first; its insets
 * centre it in its box, and every other is the same view moved to another box. Tools draw and point in the first alone.
 */
export class SideBySide {
  readonly #viewer: Viewer;
  readonly #finish = new Finish();
  #mesh: Mesh | null = null;
  #first: Box = { left: 0, top: 0, width: 1, height: 1 };
  #pictures: Picture[] = [];

  constructor(viewer: Viewer) {
    this.#viewer = viewer;
  }

  /**
   * Shows so many other shapes; until they are {@link update | updated}, a new one is the mesh's own. No boxes: the viewer's alone.
   *
   * @param first where the viewer's own shape is   @param others where the others are
   */
  show(mesh: Mesh, first: Box, others: readonly Box[]): void {
    if (mesh !== this.#mesh) this.#drop(0);
    this.#mesh = mesh;
    this.#first = first;
    this.#drop(others.length);
    others.forEach((box, k) => {
      const known = this.#pictures[k];
      if (known) known.box = box;
      else this.#pictures[k] = { body: new Body(mesh, this.#finish), box };
    });
    this.#viewer.drawPictures(others.length > 0 ? this.#draw : null);
  }

  /** Draws other positions (#P×3, the file's units) in a picture, counted from 0 without the viewer's own. */
  update(picture: number, positions: Float64Array): void {
    this.#pictures[picture]?.body.surface.write(positions);
    this.#viewer.invalidate();
  }

  dispose(): void {
    this.#drop(0);
    this.#viewer.drawPictures(null);
    this.#finish.dispose();
  }

  #drop(from: number): void {
    for (const { body } of this.#pictures.splice(from)) body.dispose();
  }

  readonly #draw = (studio: Studio): void => {
    const { renderer, turned, theme, body, shading } = studio;
    const { overlay, gizmos } = this.#viewer.space;
    this.#finish.paint(theme, this.#pictures[0]?.body.surface.hasColors ?? false);
    renderer.setScissorTest(true);
    this.#drawIn(this.#first, body, studio);
    const mine = [body?.object, overlay, gizmos].filter((one) => one !== undefined);
    const seen = mine.filter(({ visible }) => visible);
    for (const one of seen) one.visible = false;
    for (const picture of this.#pictures) {
      picture.body.shade(shading);
      turned.add(picture.body.object);
      this.#drawIn(picture.box, picture.body, studio);
      turned.remove(picture.body.object);
    }
    for (const one of seen) one.visible = true;
    renderer.setScissorTest(false);
    const { clientWidth, clientHeight } = this.#viewer.canvas;
    renderer.setViewport(0, 0, clientWidth, clientHeight);
  };

  /** The camera's picture is as large as the canvas and has its middle in the first box; moved, it has it in another. */
  #drawIn(box: Box, body: Body | null, { renderer, scene, camera, stage, zUp }: Studio): void {
    const { clientWidth, clientHeight } = this.#viewer.canvas;
    const right = middleOf(box).x - middleOf(this.#first).x;
    const down = middleOf(box).y - middleOf(this.#first).y;
    renderer.setViewport(right, -down, clientWidth, clientHeight);
    renderer.setScissor(box.left, clientHeight - box.top - box.height, box.width, box.height);
    if (body) stage.placeFloor(body.surface.lowest(zUp ? 2 : 1));
    renderer.shadowMap.needsUpdate = true;
    renderer.render(scene, camera);
  }
}
