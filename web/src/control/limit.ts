/** Keeps a user within radii about centres' vertical axes, because pictures fold beyond. */
import type { Vector } from './vector';

export interface Limit {
  readonly center: Vector;
  /** Greatest horizontal distance, metres. */
  readonly metres: number;
}

/** Where a user may be. */
export interface Bounds {
  /** Within one of these: regions that are shown or can be shown at once. Steps slow down towards the edge of all. */
  readonly open: readonly Limit[];
  /** And within all of these, the regions that are shown now: a wall, for the moment that another one takes over. */
  readonly shown: readonly Limit[];
}

/** Part of the radius at whose end steps outwards begin to shrink. */
export const FREE = 0.8;
/** How fast a user who is beyond the limit is led back: the excess shrinks by e in a third of a second. */
const RETURN = 3;

/**
 * Where a step ends that wants to lead from one place to another. Beyond the free part a step outwards counts less and
 * less: dr/ds = (m − r) / (m − free), so that r tends to m. The closed form makes one long step equal many short ones.
 */
export function confine(from: Vector, to: Vector, bounds: Bounds | null): Vector {
  const soft = bounds && roomiest(to, bounds.open);
  let place = soft ? slowed(from, to, soft) : to;
  for (const wall of bounds?.shown ?? []) {
    const end = Math.max(distance(from, wall), wall.metres);
    const far = distance(place, wall);
    if (far > end) place = atDistance(place, end, far, wall);
  }
  return place;
}

/** The part of a straight step, from 0 to 1, after which it is as far out as `confine` allows. */
export function allowedShare(from: Vector, to: Vector, bounds: Bounds | null): number {
  const soft = bounds && roomiest(to, bounds.open);
  const share = soft ? shareOf(from, to, distance(slowed(from, to, soft), soft), soft) : 1;
  const walls = (bounds?.shown ?? []).map((wall) => shareOf(from, to, wall.metres, wall));
  return Math.min(share, ...walls);
}

/** Lead a user who is beyond the limits back to them, without a jump. */
export function settle(position: Vector, bounds: Bounds | null, seconds: number): Vector {
  const soft = bounds && roomiest(position, bounds.open);
  let place = position;
  for (const limit of new Set([...(soft ? [soft] : []), ...(bounds?.shown ?? [])])) {
    const far = distance(place, limit);
    if (far <= limit.metres) continue;
    place = atDistance(place, limit.metres + (far - limit.metres) * Math.exp(-RETURN * seconds), far, limit);
  }
  return place;
}

/** Horizontal distance from the centre, metres. */
export function distance([x, , z]: Vector, { center }: Limit): number {
  return Math.hypot(x - center[0], z - center[2]);
}

/** The same place, or if it is farther than some metres from the centre, the one there that is nearest to it. */
export function within(place: Vector, limit: Limit): Vector {
  const far = distance(place, limit);
  return far <= limit.metres ? place : atDistance(place, limit.metres, far, limit);
}

/** The limit whose edge is the farthest, seen from within. */
function roomiest(place: Vector, limits: readonly Limit[]): Limit | null {
  const room = (limit: Limit): number => limit.metres - distance(place, limit);
  return limits.reduce<Limit | null>((best, each) => (best && room(best) >= room(each) ? best : each), null);
}

function slowed(from: Vector, to: Vector, limit: Limit): Vector {
  const [before, after] = [distance(from, limit), distance(to, limit)];
  const free = FREE * limit.metres;
  const start = Math.max(before, free);
  if (after <= start) return to;
  const width = limit.metres - free;
  const end = start >= limit.metres ? start : limit.metres - (limit.metres - start) * Math.exp((start - after) / width);
  return atDistance(to, end, after, limit);
}

/** The part of a step after which it is so far out, in an estimate that is never too long. */
function shareOf(from: Vector, to: Vector, end: number, limit: Limit): number {
  const [before, after] = [distance(from, limit), distance(to, limit)];
  if (after <= before || after <= end) return 1;
  return Math.max(end - before, 0) / (after - before);
}

function atDistance([x, y, z]: Vector, wanted: number, is: number, { center }: Limit): Vector {
  const share = wanted / is;
  return [center[0] + share * (x - center[0]), y, center[2] + share * (z - center[2])];
}
