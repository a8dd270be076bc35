/** The drawers that the page can use, as it uses them. */
import type { Camera } from '../cut/camera';
import type { Piece } from '../decode/leaf';
import type { Splats } from '../decode/pack';
import type { Box, Model } from '../splats/sight';

/** Something that lies on the GPU. */
export interface Held {
  readonly bytes: number;
}

/** A layer of a view that is drawn, of which a box may bound the splats' middles. */
export interface Item<Layer> {
  readonly layer: Layer;
  readonly box: Box | null;
}

export interface Drawn {
  /** Splats of parts that reach into the picture. */
  readonly splats: number;
  /** Of the geometry. */
  readonly triangles: number;
  /** Of splats, light and geometry. */
  readonly calls: number;
}

/** Draws layers of views, and meshes of leaves. */
export interface Drawer<Layer extends Held, Mesh extends Held> {
  upload(model: Model, splats: Splats): Layer;
  drop(layer: Layer): void;
  uploadMesh(piece: Piece): Mesh;
  dropMesh(mesh: Mesh): void;
  /** Draw meshes and layers with `grid` × `grid` samples for each pixel; the nearest ones should come first. */
  draw(meshes: readonly Mesh[], items: readonly Item<Layer>[], camera: Camera, grid: number): Drawn;
  /** Whether the last picture is there, and not only asked for. */
  readonly isDone: boolean;
  /** Wait until it is. */
  finish(): Promise<void>;
  /**
   * Splats of parts that do not lie behind others, of the last picture that is there; a part counts once for each band of
   * rows. Null where hidden parts are drawn, too.
   */
  readonly unhidden: number | null;
}
