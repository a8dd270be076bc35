/** World point at which the user points. */
import { directionTo } from '../control/places';
import type { Pose } from '../control/pose';
import { minus, addScaled, type Vector } from '../control/vector';
import type { Viewer } from '../show/viewer';
import type { Place } from './hold';
import { rangeIn } from './ranges';
import { pointShownAt } from './unmorph';

/** Metres to points without a range, from the centre, and length of a pointer that hits nothing. */
export const NOTHING_HIT = 100;
/** Multiple of the morph's radius within which the map shows nothing. */
const BEYOND = 2;

/**
 * Computes the world point behind a place of the picture: a point of near geometry, with the morph inverted except left
 * of the divider, where nothing is morphed; or a point of the map, by its range from the centre.
 */
export function targetAt(viewer: Viewer, nearShare: number, pose: Pose, [x, y]: Place): Vector {
  const { shown, entry } = viewer.facts;
  const { radius, strength } = shown?.grown ?? { radius: 0, strength: 0 };
  const center: Vector = entry?.center ?? pose.position;
  const seen = viewer.pointAt(x, y);
  if (seen && !viewer.isMorphedAt(x)) return seen;
  if (seen) {
    const morph = { user: minus(pose.position, center), inner: nearShare * radius, radius, strength };
    const found = pointShownAt(minus(seen, pose.position), morph);
    return found ? addScaled(center, found, 1) : seen;
  }
  const { camera, renderer, shared } = viewer;
  const direction = directionTo(pose, [x, y], Math.tan((camera.fov * Math.PI) / 360), camera.aspect);
  const range = rangeIn(renderer, shared, direction) ?? Math.max(NOTHING_HIT, BEYOND * radius);
  return addScaled(center, direction, range);
}
