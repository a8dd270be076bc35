/** The point of the world at which the user points. */
import { directionTo } from '../control/places';
import type { Pose } from '../control/pose';
import { minus, moved, type Vector } from '../control/vector';
import type { Viewer } from '../show/viewer';
import type { Place } from './hold';
import { rangeIn } from './ranges';
import { pointShownAt } from './unmorph';

/** Metres to what has no range, from the centre; a pointer from a hand that hits nothing is as long. */
export const NOTHING_HIT = 100;
/** Radii of the morph within which the map shows nothing. */
const BEYOND = 2;

/**
 * The point that a part of the picture shows: near geometry, whose place is found back from where the morph shows it,
 * but left of the divider, where nothing is morphed; or what the map shows, by its range from the centre.
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
    return found ? moved(center, found, 1) : seen;
  }
  const { camera, renderer, shared } = viewer;
  const direction = directionTo(pose, [x, y], Math.tan((camera.fov * Math.PI) / 360), camera.aspect);
  const range = rangeIn(renderer, shared, direction) ?? Math.max(NOTHING_HIT, BEYOND * radius);
  return moved(center, direction, range);
}
