/** Keeps a user within a radius about a centre's vertical axis, because pictures fold beyond. */
import type { Vector } from './vector';

export interface Limit {
  readonly center: Vector;
  /** Greatest horizontal distance, metres. */
  readonly metres: number;
}

/** Part of the radius at whose end steps outwards begin to shrink. */
const FREE = 0.8;
/** How fast a user who is beyond the limit is led back: the excess shrinks by e in a third of a second. */
const RETURN = 3;

/**
 * Where a step ends that wants to lead from one place to another. Beyond the free part a step outwards counts less and
 * less: dr/ds = (m − r) / (m − free), so that r tends to m. The closed form makes one long step equal many short ones.
 */
export function confine(from: Vector, to: Vector, limit: Limit | null): Vector {
  if (!limit) return to;
  const [before, after] = [distance(from, limit), distance(to, limit)];
  const free = FREE * limit.metres;
  const start = Math.max(before, free);
  if (after <= start) return to;
  const width = limit.metres - free;
  const end = start >= limit.metres ? start : limit.metres - (limit.metres - start) * Math.exp((start - after) / width);
  return atDistance(to, end, after, limit);
}

/** The part of a straight step, from 0 to 1, after which it is as far out as `confine` allows. */
export function allowedShare(from: Vector, to: Vector, limit: Limit | null): number {
  if (!limit) return 1;
  const [before, after] = [distance(from, limit), distance(to, limit)];
  if (after <= before) return 1;
  return (distance(confine(from, to, limit), limit) - before) / (after - before);
}

/** Lead a user who is beyond the limit back to it, without a jump. */
export function settle(position: Vector, limit: Limit | null, seconds: number): Vector {
  const far = limit ? distance(position, limit) : 0;
  if (!limit || far <= limit.metres) return position;
  return atDistance(position, limit.metres + (far - limit.metres) * Math.exp(-RETURN * seconds), far, limit);
}

/** Horizontal distance from the centre, metres. */
export function distance([x, , z]: Vector, { center }: Limit): number {
  return Math.hypot(x - center[0], z - center[2]);
}

function atDistance([x, y, z]: Vector, wanted: number, is: number, { center }: Limit): Vector {
  const share = wanted / is;
  return [center[0] + share * (x - center[0]), y, center[2] + share * (z - center[2])];
}
