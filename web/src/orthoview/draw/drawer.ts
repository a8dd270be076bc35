/** Common interface of the page's drawers, their near plane, and their limit on samples. */
import type { Camera } from '../cut/camera';
import type { Piece } from '../decode/leaf';
import type { Splats } from '../decode/pack';
import type { CellKey } from '../store/layout';
import type { Model } from './sight';

/** A resource on the GPU. */
export interface GpuResource {
  readonly bytes: number;
}

/** A layer of a view to draw; `box` bounds the splats' centres if it is known. */
export interface Item<Layer> {
  readonly layer: Layer;
  readonly box: CellKey | null;
}

export interface FrameCounts {
  /** Splats of parts that are at least partly in the picture. */
  readonly splats: number;
  /** Triangles of the geometry. */
  readonly triangles: number;
  /** Draw calls for splats, lighting and geometry. */
  readonly calls: number;
}

/** Draws layers of views, and meshes of leaves. */
export interface Drawer<Layer extends GpuResource, Mesh extends GpuResource> {
  upload(model: Model, splats: Splats): Layer;
  drop(layer: Layer): void;
  readonly meshes: { upload(piece: Piece): Mesh; drop(mesh: Mesh): void };
  /** Draws meshes and layers with `grid` × `grid` samples per pixel; the nearest of each should come first. */
  draw(meshes: readonly Mesh[], items: readonly Item<Layer>[], camera: Camera, grid: number): FrameCounts;
  /** Whether the GPU has finished the last picture. */
  readonly isDone: boolean;
  /** Waits until the GPU has finished the last picture. */
  finish(): Promise<void>;
  /** Splats of unoccluded parts in the last finished picture, by bands of rows; null if occluded ones are drawn. */
  readonly unhidden: number | null;
}

/** Greatest near distance with meshes, metres along the viewing axis. */
const MESH_NEAR_DISTANCE = 0.05;

/** Near distance in metres along the viewing axis; depth values are this divided by the point's distance. */
export function nearDistanceOf(items: readonly Item<{ readonly model: Model }>[], hasMeshes: boolean): number {
  let least = 1e6;
  for (const { layer } of items) least = Math.min(least, Math.max(layer.model.pitch[0], layer.model.pitch[1]));
  return hasMeshes ? Math.min(least / 2, MESH_NEAR_DISTANCE) : least / 2;
}

/** Samples along each axis of a pixel, reduced so that `length` pixels need at most `maxLength` texels. */
export function gridOf(grid: number, length: number, maxLength: number): number {
  return Math.max(Math.min(grid, Math.floor(maxLength / length)), 1);
}
