/** Common interface of the WebGL and WebGPU drawers, their near plane, and their number of samples. */
import type { Camera } from '../cut/camera';
import type { Piece } from '../decode/leaf';
import type { Splats } from '../decode/pack';
import type { CellKey } from '../store/layout';
import type { Model } from './projection';

/** A resource on the GPU. */
export interface GpuResource {
  readonly bytes: number;
}

/** A layer of a view to draw: of all its splats, or of those with centres in a box. */
export interface Item<Layer> {
  readonly layer: Layer;
  readonly box: CellKey | null;
}

export interface FrameCounts {
  /** Splats of the parts that are at least partly in the picture. */
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
  /** Draws meshes and layers, preferably nearest first, with `grid` × `grid` samples per pixel. */
  draw(meshes: readonly Mesh[], items: readonly Item<Layer>[], camera: Camera, grid: number): FrameCounts;
  /** Whether the GPU has finished the last picture. */
  readonly isDone: boolean;
  /** Waits until the GPU has finished the last picture. */
  finish(): Promise<void>;
  /** Splats of unoccluded parts in the last finished picture; null if the drawer also draws occluded parts. */
  readonly drawnSplats: number | null;
}

/** Greatest near distance of pictures with meshes, metres along the viewing axis. */
const MESH_NEAR_DISTANCE = 0.05;

/** Near distance, metres along the viewing axis. A depth value is the near distance divided by a point's distance. */
export function nearDistanceOf(items: readonly Item<{ readonly model: Model }>[], hasMeshes: boolean): number {
  let least = 1e6;
  for (const { layer } of items) least = Math.min(least, Math.max(layer.model.pitch[0], layer.model.pitch[1]));
  return hasMeshes ? Math.min(least / 2, MESH_NEAR_DISTANCE) : least / 2;
}

/** Reduces the number of samples along a pixel's axis so that `length` pixels need at most `maxLength` texels. */
export function gridOf(grid: number, length: number, maxLength: number): number {
  return Math.max(Math.min(grid, Math.floor(maxLength / length)), 1);
}
