/** Where depths end, and how many samples a picture may have. */
import type { Model } from '../splats/sight';
import type { Item } from './drawer';

/** Metres along the axis at which geometry ends. */
const NEAREST = 0.05;

/** Metres along the axis nearer than which nothing is shown: depths are this over the distance. */
export function nearestOf(items: readonly Item<{ readonly model: Model }>[], hasMeshes: boolean): number {
  let least = 1e6;
  for (const { layer } of items) least = Math.min(least, Math.max(layer.model.pitch[0], layer.model.pitch[1]));
  return hasMeshes ? Math.min(least / 2, NEAREST) : least / 2;
}

/** Samples along each axis of a pixel, so that `length` pixels of them are no longer than a texture may be. */
export function gridOf(grid: number, length: number, longest: number): number {
  return Math.max(Math.min(grid, Math.floor(longest / length)), 1);
}
