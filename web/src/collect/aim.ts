/** Target point beside or on a sphere for a picture position, so that a hand beside the eyes points there, too. */
import { directionTo } from '../control/places';
import type { Pose } from '../control/pose';
import { minus, addScaled, type Vector } from '../control/vector';
import type { Place } from '../rooms/hold';
import { shownAt } from '../rooms/unmorph';
import type { Viewer } from '../show/viewer';

/** Greatest tangent of the angle between the direction and the sphere's centre at which the sphere is meant. */
const MEANT = 0.5;

/** Point at the sphere's distance; null for directions that miss it. */
export function pointBeside(
  viewer: Viewer,
  nearShare: number,
  pose: Pose,
  place: Place,
  sphere: Vector,
): Vector | null {
  const { camera, facts } = viewer;
  const { radius, strength } = facts.shown?.grown ?? { radius: 0, strength: 0 };
  const center: Vector = facts.entry?.center ?? pose.position;
  const morph = { user: minus(pose.position, center), inner: nearShare * radius, radius, strength };
  const seen = shownAt(minus(sphere, center), morph);
  const [dx, dy, dz] = directionTo(pose, place, Math.tan((camera.fov * Math.PI) / 360), camera.aspect);
  const along = seen[0] * dx + seen[1] * dy + seen[2] * dz;
  const aside = minus([along * dx, along * dy, along * dz], seen);
  return along > 0 && Math.hypot(...aside) <= MEANT * along ? addScaled(sphere, aside, 1) : null;
}
