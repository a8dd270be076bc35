/** Keeps a user within radii about centres' vertical axes, because pictures fold beyond them. */
import type { Vector } from './pose';

export interface Limit {
  readonly center: Vector;
  /** Greatest horizontal distance, metres. */
  readonly metres: number;
}

export interface Bounds {
  /**
   * At least one of these must contain the user: regions that can be shown at once. Steps slow down towards their edge.
   */
  readonly open: readonly Limit[];
  /** All of these must contain the user: the regions shown now, a hard wall until another region takes over. */
  readonly shown: readonly Limit[];
}

/** Share of the radius from which outward steps shrink. */
export const FREE = 0.8;
/** Rate per second at which a user beyond the limit is led back: the excess falls by e in a third of a second. */
const RETURN_RATE = 3;

/**
 * End of a step from one place to another. Beyond the free part an outward step counts less and less: dr/ds = (m − r) /
 * (m − free), so that r tends to m. The closed form makes one long step equal many short ones.
 */
export function confine(from: Vector, to: Vector, bounds: Bounds | null): Vector {
  const soft = bounds && withMostSpace(to, bounds.open);
  let place = soft ? slowDown(from, to, soft) : to;
  for (const wall of bounds?.shown ?? []) {
    place = clampToLimit(place, { ...wall, metres: Math.max(distance(from, wall), wall.metres) });
  }
  return place;
}

/** Share of a straight step, 0 to 1, after which it is as far out as `confine` allows. */
export function allowedShare(from: Vector, to: Vector, bounds: Bounds | null): number {
  const soft = bounds && withMostSpace(to, bounds.open);
  const share = soft ? shareOf(from, to, distance(slowDown(from, to, soft), soft), soft) : 1;
  const walls = (bounds?.shown ?? []).map((wall) => shareOf(from, to, wall.metres, wall));
  return Math.min(share, ...walls);
}

/** Leads a user who is beyond the limits back smoothly. */
export function leadBack(position: Vector, bounds: Bounds | null, seconds: number): Vector {
  const soft = bounds && withMostSpace(position, bounds.open);
  let place = position;
  for (const limit of new Set([...(soft ? [soft] : []), ...(bounds?.shown ?? [])])) {
    const excess = distance(place, limit) - limit.metres;
    if (excess > 0) place = atDistance(place, limit.metres + excess * Math.exp(-RETURN_RATE * seconds), limit);
  }
  return place;
}

/** Horizontal distance from the centre, metres. */
export function distance([x, , z]: Vector, { center }: Limit): number {
  return Math.hypot(x - center[0], z - center[2]);
}

/** The place, moved towards the centre's axis if it is beyond the limit. */
export function clampToLimit(place: Vector, limit: Limit): Vector {
  return distance(place, limit) <= limit.metres ? place : atDistance(place, limit.metres, limit);
}

/** The limit whose edge is farthest from an inside position. */
function withMostSpace(place: Vector, limits: readonly Limit[]): Limit | null {
  const space = (limit: Limit): number => limit.metres - distance(place, limit);
  return limits.reduce<Limit | null>((best, each) => (best && space(best) >= space(each) ? best : each), null);
}

function slowDown(from: Vector, to: Vector, limit: Limit): Vector {
  const [before, after] = [distance(from, limit), distance(to, limit)];
  const freeDistance = FREE * limit.metres;
  const start = Math.max(before, freeDistance);
  if (after <= start) return to;
  const width = limit.metres - freeDistance;
  const end = start >= limit.metres ? start : limit.metres - (limit.metres - start) * Math.exp((start - after) / width);
  return atDistance(to, end, limit);
}

/** Conservative estimate of the share of a step after which it reaches a distance. */
function shareOf(from: Vector, to: Vector, end: number, limit: Limit): number {
  const [before, after] = [distance(from, limit), distance(to, limit)];
  if (after <= before || after <= end) return 1;
  return Math.max(end - before, 0) / (after - before);
}

/** Place in the same direction from the centre's axis, at another distance from it. */
function atDistance(place: Vector, metres: number, limit: Limit): Vector {
  const [[x, y, z], [centerX, , centerZ]] = [place, limit.center];
  const factor = metres / distance(place, limit);
  return [centerX + factor * (x - centerX), y, centerZ + factor * (z - centerZ)];
}
