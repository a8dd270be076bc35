/** Keeps a user inside a cylinder around each region's centre; outside it the morphed picture folds over itself. */
import type { Vector } from './pose';

export interface Limit {
  readonly center: Vector;
  /** Maximum horizontal distance, metres. */
  readonly metres: number;
}

export interface Bounds {
  /** Limits of the regions that can be shown immediately: the user stays in at least one, slowing down at its edge. */
  readonly soft: readonly Limit[];
  /** Limits of the regions that are shown now: the user stays in all of them. */
  readonly hard: readonly Limit[];
}

/** Share of the radius from which outward steps shrink. */
export const FREE_SHARE = 0.8;
/**
 * Rate per second at which a user beyond a limit is led back: the excess distance falls to 1/e in a third of a second.
 */
const RETURN_RATE = 3;

/**
 * End of a step from one place to another. Beyond the share f = FREE_SHARE of a limit m, the distance r from the centre
 * grows less than an outward step s: dr/ds = (m − r) / (m − f m), so r tends to m. A long step equals many short ones.
 */
export function confine(from: Vector, to: Vector, bounds: Bounds | null): Vector {
  const soft = bounds && limitWithMostRoom(to, bounds.soft);
  let place = soft ? slowDown(from, to, soft) : to;
  for (const wall of bounds?.hard ?? [])
    place = clampToLimit(place, { ...wall, metres: Math.max(distance(from, wall), wall.metres) });
  return place;
}

/** Share of a straight step, 0 to 1, that can be taken before `confine` would stop it. */
export function allowedShare(from: Vector, to: Vector, bounds: Bounds | null): number {
  const soft = bounds && limitWithMostRoom(to, bounds.soft);
  const share = soft ? shareOf(from, to, distance(slowDown(from, to, soft), soft), soft) : 1;
  const walls = (bounds?.hard ?? []).map((wall) => shareOf(from, to, wall.metres, wall));
  return Math.min(share, ...walls);
}

/** Moves a user who is beyond the limits smoothly back. */
export function leadBack(position: Vector, bounds: Bounds | null, seconds: number): Vector {
  const soft = bounds && limitWithMostRoom(position, bounds.soft);
  let place = position;
  for (const limit of new Set([...(soft ? [soft] : []), ...(bounds?.hard ?? [])])) {
    const excess = distance(place, limit) - limit.metres;
    if (excess > 0) place = moveToDistance(place, limit.metres + excess * Math.exp(-RETURN_RATE * seconds), limit);
  }
  return place;
}

/** Horizontal distance from the centre, metres. */
export function distance([x, , z]: Vector, { center }: Limit): number {
  return Math.hypot(x - center[0], z - center[2]);
}

/** Moves a place beyond the limit to the limit, towards the centre's axis. */
export function clampToLimit(place: Vector, limit: Limit): Vector {
  return distance(place, limit) <= limit.metres ? place : moveToDistance(place, limit.metres, limit);
}

/** Limit with the greatest distance from a place outward to its edge; the distance is negative outside the limit. */
function limitWithMostRoom(place: Vector, limits: readonly Limit[]): Limit | null {
  const space = (limit: Limit): number => limit.metres - distance(place, limit);
  return limits.reduce<Limit | null>((best, each) => (best && space(best) >= space(each) ? best : each), null);
}

function slowDown(from: Vector, to: Vector, limit: Limit): Vector {
  const [before, after] = [distance(from, limit), distance(to, limit)];
  const freeDistance = FREE_SHARE * limit.metres;
  const start = Math.max(before, freeDistance);
  if (after <= start) return to;
  const width = limit.metres - freeDistance;
  const end = start >= limit.metres ? start : limit.metres - (limit.metres - start) * Math.exp((start - after) / width);
  return moveToDistance(to, end, limit);
}

/**
 * Share of a step at which the distance from the centre's axis reaches `end`: exact for a step straight outward, too
 * small for others, because the distance is a convex function along the step.
 */
function shareOf(from: Vector, to: Vector, end: number, limit: Limit): number {
  const [before, after] = [distance(from, limit), distance(to, limit)];
  if (after <= before || after <= end) return 1;
  return Math.max(end - before, 0) / (after - before);
}

/** Moves a place to another distance from the centre's axis, in the same direction. */
function moveToDistance(place: Vector, metres: number, limit: Limit): Vector {
  const [[x, y, z], [centerX, , centerZ]] = [place, limit.center];
  const factor = metres / distance(place, limit);
  return [centerX + factor * (x - centerX), y, centerZ + factor * (z - centerZ)];
}
