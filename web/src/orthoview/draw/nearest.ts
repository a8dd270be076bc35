/** Where depths end. */
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
