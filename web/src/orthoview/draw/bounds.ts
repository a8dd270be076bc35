/** Near plane, and limit on the samples of a picture. */
import type { Model } from '../splats/sight';
import type { Item } from './drawer';

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
