/** Common interface of the page's drawers, their near plane, and their limit on samples. */
import type { Camera } from '../cut/camera';
import type { Piece } from '../decode/leaf';
import type { Splats } from '../decode/pack';
import type { Box, Model } from './sight';

/** A resource on the GPU. */
export interface Held {
  readonly bytes: number;
}

/** A drawn layer of a view; `box` may bound the splats' centres. */
export interface Item<Layer> {
  readonly layer: Layer;
  readonly box: Box | null;
}

export interface Drawn {
  /** Splats of parts that reach into the picture. */
  readonly splats: number;
  /** Triangles of the geometry. */
  readonly triangles: number;
  /** Draw calls for splats, lighting and geometry. */
  readonly calls: number;
}

/** Draws layers of views, and meshes of leaves. */
export interface Drawer<Layer extends Held, Mesh extends Held> {
  upload(model: Model, splats: Splats): Layer;
  drop(layer: Layer): void;
  uploadMesh(piece: Piece): Mesh;
  dropMesh(mesh: Mesh): void;
  /** Draws meshes and layers with `grid` × `grid` samples per pixel; the nearest ones should come first. */
  draw(meshes: readonly Mesh[], items: readonly Item<Layer>[], camera: Camera, grid: number): Drawn;
  /** Whether the GPU has finished the last picture. */
  readonly isDone: boolean;
  /** Waits until the GPU has finished the last picture. */
  finish(): Promise<void>;
  /**
   * Splats of unoccluded parts in the last finished picture; a part counts once for each band of rows. Null if occluded
   * parts are drawn, too.
   */
  readonly unhidden: number | null;
}

/** Near distance for geometry, metres along the axis. */
const NEAREST = 0.05;

/** Near distance in metres along the axis; depth values are this divided by the distance. */
export function nearestOf(items: readonly Item<{ readonly model: Model }>[], hasMeshes: boolean): number {
  let least = 1e6;
  for (const { layer } of items) least = Math.min(least, Math.max(layer.model.pitch[0], layer.model.pitch[1]));
  return hasMeshes ? Math.min(least / 2, NEAREST) : least / 2;
}

/** Samples along each axis of a pixel, reduced so that `length` pixels of them fit into a texture. */
export function gridOf(grid: number, length: number, longest: number): number {
  return Math.max(Math.min(grid, Math.floor(longest / length)), 1);
}
